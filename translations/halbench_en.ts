<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>halbench::app::ConfigurationPanel</name>
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
        <source>%n row(s) not restored; the rows say why.</source>
        <translation>
            <numerusform>%n row not restored; the row says why.</numerusform>
            <numerusform>%n rows not restored; the rows say why.</numerusform>
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
        <source>%Ln row(s) came faster than the window could show them and are not drawn</source>
        <translation>
            <numerusform>%Ln row came faster than the window could show it and is not drawn</numerusform>
            <numerusform>%Ln rows came faster than the window could show them and are not drawn</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::MainWindow</name>
    <message numerus="yes">
        <source>%n recording(s) of %1 are beyond the limits of the preferences and stay for now.</source>
        <translation>
            <numerusform>%n recording of %1 is beyond the limits of the preferences and stays for now.</numerusform>
            <numerusform>%n recordings of %1 are beyond the limits of the preferences and stay for now.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorRecording</name>
    <message numerus="yes">
        <source>%n signal(s), %1 Hz, rows lost: %2</source>
        <translation>
            <numerusform>%n signal, %1 Hz, rows lost: %2</numerusform>
            <numerusform>%n signals, %1 Hz, rows lost: %2</numerusform>
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
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With OK %n recording(s) go to the trash now (%1), from %2.</source>
        <translation>
            <numerusform>With OK %n recording goes to the trash now (%1), from %2.</numerusform>
            <numerusform>With OK %n recordings go to the trash now (%1), from %2.</numerusform>
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
