<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>halbench::app::ConfigurationPanel</name>
    <message numerus="yes">
        <source>%n row(s) not restored; see the rows for the cause.</source>
        <translation>
            <numerusform>%n row not restored; see the row for the cause.</numerusform>
            <numerusform>%n rows not restored; see the rows for the cause.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Restore %n row(s)</source>
        <translation>
            <numerusform>Restore %n row</numerusform>
            <numerusform>Restore %n rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) saved.</source>
        <translation>
            <numerusform>%n setting saved.</numerusform>
            <numerusform>%n settings saved.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) restored and read back.</source>
        <translation>
            <numerusform>%n row restored and read back.</numerusform>
            <numerusform>%n rows restored and read back.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::DeviceSession</name>
    <message numerus="yes">
        <source>%Ln sample(s) not shown: rate too high for the window</source>
        <translation>
            <numerusform>%Ln sample not shown: rate too high for the window</numerusform>
            <numerusform>%Ln samples not shown: rate too high for the window</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::LinkPanel</name>
    <message numerus="yes">
        <source>%n signal(s), %1 Hz, samples lost: %2</source>
        <translation>
            <numerusform>%n signal, %1 Hz, samples lost: %2</numerusform>
            <numerusform>%n signals, %1 Hz, samples lost: %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::MainWindow</name>
    <message numerus="yes">
        <source>%n recording(s) of %1 exceed the limits in the preferences and are kept for now.</source>
        <translation>
            <numerusform>%n recording of %1 exceeds the limits in the preferences and is kept for now.</numerusform>
            <numerusform>%n recordings of %1 exceed the limits in the preferences and are kept for now.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::ParametersPanel</name>
    <message numerus="yes">
        <source>%n value(s) written and read back.</source>
        <translation>
            <numerusform>%n value written and read back.</numerusform>
            <numerusform>%n values written and read back.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordPanel</name>
    <message numerus="yes">
        <source>%Ln row(s) in %1</source>
        <translation>
            <numerusform>%Ln row in %1</numerusform>
            <numerusform>%Ln rows in %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingFields</name>
    <message numerus="yes">
        <source>OK moves %n recording(s) to the trash now (%1), from %2.</source>
        <translation>
            <numerusform>OK moves %n recording to the trash now (%1), from %2.</numerusform>
            <numerusform>OK moves %n recordings to the trash now (%1), from %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrumFigure</name>
    <message numerus="yes">
        <source>%Ln average(s)</source>
        <translation>
            <numerusform>%Ln average</numerusform>
            <numerusform>%Ln averages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::TunePages</name>
    <message numerus="yes">
        <source>%n control loop(s), no identification procedure. Edit the gains in Parameters and check them with a reference in Drive.</source>
        <translation>
            <numerusform>%n control loop, no identification procedure. Edit the gains in Parameters and check them with a reference in Drive.</numerusform>
            <numerusform>%n control loops, no identification procedure. Edit the gains in Parameters and check them with a reference in Drive.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::widgets::MarkerBar</name>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n marker</numerusform>
            <numerusform>%n markers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::widgets::RotorView</name>
    <message numerus="yes">
        <source>%n separate magnets</source>
        <translation>
            <numerusform>%n separate magnet</numerusform>
            <numerusform>%n separate magnets</numerusform>
        </translation>
    </message>
</context>
</TS>
