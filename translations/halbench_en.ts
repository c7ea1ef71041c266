<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
