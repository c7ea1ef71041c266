<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Panels</name>
    <message>
        <source>Monitor</source>
        <translation>Monitor</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifizieren</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Auslegen</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Field &amp;&amp; Pose</source>
        <translation>Feld &amp;&amp; Lage</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Antrieb</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibratePanel</name>
    <message>
        <source>Save calibration</source>
        <translation>Kalibrierung speichern</translation>
    </message>
    <message>
        <source>Calibration (*.json)</source>
        <translation>Kalibrierung (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>Vorschlagen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Finds what the angle sensors and the coils do to the measured angle, and how much current the rotor needs to start.</source>
        <translation>Ermittelt, was Winkelsensoren und Spulen am gemessenen Winkel verfälschen und wie viel Strom der Rotor zum Losbrechen braucht.</translation>
    </message>
    <message>
        <source>&amp;Hall sensors</source>
        <translation>Ha&amp;ll-Sensoren</translation>
    </message>
    <message>
        <source>Two offsets, gain, right angle and amplitude from the ellipse of the readings</source>
        <translation>Zwei Offsets, Verstärkung, rechter Winkel und Amplitude aus der Ellipse der Messwerte</translation>
    </message>
    <message>
        <source>&amp;Stray field of the coils</source>
        <translation>&amp;Streufeld der Spulen</translation>
    </message>
    <message>
        <source>Without it the recommended gains are unstable</source>
        <translation>Ohne es sind die empfohlenen Reglerparameter instabil</translation>
    </message>
    <message>
        <source>Static &amp;friction</source>
        <translation>Haf&amp;treibung</translation>
    </message>
    <message>
        <source>A figure only: it changes no parameter</source>
        <translation>Nur eine Kennzahl: ändert keinen Parameter</translation>
    </message>
    <message>
        <source>Start calibration</source>
        <translation>Kalibrierung starten</translation>
    </message>
    <message>
        <source>The rotor moves; Esc stops it</source>
        <translation>Der Rotor bewegt sich; Esc stoppt ihn</translation>
    </message>
    <message>
        <source>Write the proposed values in one transaction and read them back</source>
        <translation>Die vorgeschlagenen Werte in einem Vorgang schreiben und zurücklesen</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Write the values from before the calibration</source>
        <translation>Die Werte von vor der Kalibrierung schreiben</translation>
    </message>
    <message>
        <source>Save calibration…</source>
        <translation>Kalibrierung speichern …</translation>
    </message>
    <message>
        <source>Write the result as a file</source>
        <translation>Das Ergebnis als Datei schreiben</translation>
    </message>
    <message>
        <source>Calibrate again</source>
        <translation>Neu kalibrieren</translation>
    </message>
    <message>
        <source>Back to the choice</source>
        <translation>Zurück zur Auswahl</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>The calibration was cancelled; everything is as it was before.</source>
        <translation>Die Kalibrierung wurde abgebrochen; alles ist, wie es war.</translation>
    </message>
    <message>
        <source>Calibrated values</source>
        <translation>Kalibrierte Werte</translation>
    </message>
    <message>
        <source>Applied and read back; it stays until the device is switched off.</source>
        <translation>Übernommen und zurückgelesen; gilt, bis das Gerät ausgeschaltet wird.</translation>
    </message>
    <message>
        <source>The values from before are back.</source>
        <translation>Die Werte von vorher gelten wieder.</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibrateWords</name>
    <message>
        <source>offset of Hall sensor A</source>
        <translation>Offset des Hall-Sensors A</translation>
    </message>
    <message>
        <source>offset of Hall sensor B</source>
        <translation>Offset des Hall-Sensors B</translation>
    </message>
    <message>
        <source>gain of B over A</source>
        <translation>Verstärkung von B gegen A</translation>
    </message>
    <message>
        <source>error of the right angle</source>
        <translation>Fehler des rechten Winkels</translation>
    </message>
    <message>
        <source>amplitude of the field</source>
        <translation>Amplitude des Feldes</translation>
    </message>
    <message>
        <source>stray field of the coils</source>
        <translation>Streufeld der Spulen</translation>
    </message>
    <message>
        <source>breakaway current, static</source>
        <translation>Losbrechstrom, statisch</translation>
    </message>
    <message>
        <source>Hall: the rotor turns slowly both ways at %1.</source>
        <translation>Hall: Der Rotor dreht langsam in beide Richtungen mit %1.</translation>
    </message>
    <message>
        <source>Stray field: the rotor is held at three angles, without torque, at up to %1.</source>
        <translation>Streufeld: Der Rotor wird in drei Winkeln ohne Drehmoment gehalten, mit bis zu %1.</translation>
    </message>
    <message>
        <source>Static friction: the current rises to at most %1 until the rotor starts, %2 times each way.</source>
        <translation>Haftreibung: Der Strom steigt bis höchstens %1, bis der Rotor losbricht, %2-mal je Richtung.</translation>
    </message>
    <message>
        <source>Choose at least one calibration.</source>
        <translation>Wählen Sie mindestens eine Kalibrierung.</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 rad/s. Nothing is changed until you apply it.</source>
        <translation>Das Steuergerät beendet die Bewegung bei %1 rad/s. Nichts wird geändert, bis Sie es übernehmen.</translation>
    </message>
    <message>
        <source>a figure only</source>
        <translation>nur eine Kennzahl</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>Angle error (rms): %1 with the present values, %2 with the proposed ones.</source>
        <translation>Winkelfehler (Effektivwert): %1 mit den jetzigen Werten, %2 mit den vorgeschlagenen.</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibrationFigures</name>
    <message>
        <source>current at the first motion</source>
        <translation>Strom bei der ersten Bewegung</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>reverse, sign removed</source>
        <translation>rückwärts, ohne Vorzeichen</translation>
    </message>
    <message>
        <source>Static friction over the angle</source>
        <translation>Haftreibung über dem Winkel</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
</context>
<context>
    <name>halbench::app::DevicePanel</name>
    <message>
        <source>Devices that can be connected</source>
        <translation>Geräte, die verbunden werden können</translation>
    </message>
    <message>
        <source>Enter or double click connects</source>
        <translation>Eingabetaste oder Doppelklick verbindet</translation>
    </message>
    <message>
        <source>Device address</source>
        <translation>Adresse des Geräts</translation>
    </message>
    <message>
        <source>For example sim:htm?seed=7 or tcp:HOST:PORT</source>
        <translation>Zum Beispiel sim:htm?seed=7 oder tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>sim:htm or tcp:HOST:PORT</source>
        <translation>sim:htm oder tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>Simulated &amp;time</source>
        <translation>Simulierte &amp;Zeit</translation>
    </message>
    <message>
        <source>Speed of simulated time</source>
        <translation>Geschwindigkeit der simulierten Zeit</translation>
    </message>
    <message>
        <source>How fast the simulated motor lives; a real device has its own time</source>
        <translation>Wie schnell der simulierte Motor läuft; ein echtes Gerät hat seine eigene Zeit</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>5 times</source>
        <translation>5-fach</translation>
    </message>
    <message>
        <source>20 times</source>
        <translation>20-fach</translation>
    </message>
    <message>
        <source>100 times</source>
        <translation>100-fach</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>so schnell wie möglich</translation>
    </message>
    <message>
        <source>Identity of the device</source>
        <translation>Identität des Geräts</translation>
    </message>
    <message>
        <source>Model, identity and firmware as the device says</source>
        <translation>Modell, Kennung und Firmware, wie das Gerät sie angibt</translation>
    </message>
    <message>
        <source>No device is named.</source>
        <translation>Es ist kein Gerät angegeben.</translation>
    </message>
    <message>
        <source>Choose one from the list or write its address.</source>
        <translation>Wählen Sie eines aus der Liste oder schreiben Sie seine Adresse.</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>Verbi&amp;nden</translation>
    </message>
    <message>
        <source>Dis&amp;connect</source>
        <translation>Tre&amp;nnen</translation>
    </message>
    <message>
        <source>Connect the device (Alt+C)</source>
        <translation>Das Gerät verbinden (Alt+N)</translation>
    </message>
    <message>
        <source>End what runs, disarm and disconnect (Alt+C)</source>
        <translation>Beenden, was läuft, sperren und trennen (Alt+N)</translation>
    </message>
    <message>
        <source>%1
Firmware %2</source>
        <translation>%1
Firmware %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::DeviceSession</name>
    <message>
        <source>board</source>
        <translation>Steuergerät</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>connecting %1</source>
        <translation>%1 wird verbunden</translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation>getrennt</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>connected %1, firmware %2</source>
        <translation>%1 verbunden, Firmware %2</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>the window did not answer while the actuator was armed, so it was stopped</source>
        <translation>Das Fenster antwortete nicht, während der Aktor freigegeben war; deshalb wurde er gestoppt</translation>
    </message>
</context>
<context>
    <name>halbench::app::DisplayQuantity</name>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>r/min</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>current slope</source>
        <translation>Stromanstieg</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Führungsgröße</translation>
    </message>
    <message>
        <source>Current command</source>
        <translation>Stromsollwert</translation>
    </message>
    <message>
        <source>Current A</source>
        <translation>Strom A</translation>
    </message>
    <message>
        <source>Current B</source>
        <translation>Strom B</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>Hall A</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>Hall B</translation>
    </message>
    <message>
        <source>Coil A</source>
        <translation>Spule A</translation>
    </message>
    <message>
        <source>Coil B</source>
        <translation>Spule B</translation>
    </message>
    <message>
        <source>Board state</source>
        <translation>Zustand des Steuergeräts</translation>
    </message>
    <message>
        <source>Fault code</source>
        <translation>Fehlernummer</translation>
    </message>
    <message>
        <source>Torn parameter sets</source>
        <translation>Zerrissene Parametersätze</translation>
    </message>
    <message>
        <source>Generator segment</source>
        <translation>Abschnitt des Generators</translation>
    </message>
    <message>
        <source>Generator running</source>
        <translation>Generator läuft</translation>
    </message>
    <message>
        <source>Capture state</source>
        <translation>Zustand der Aufnahme</translation>
    </message>
    <message>
        <source>Capture time</source>
        <translation>Zeit der Aufnahme</translation>
    </message>
    <message>
        <source>True angle</source>
        <translation>Wahrer Winkel</translation>
    </message>
    <message>
        <source>True speed</source>
        <translation>Wahre Drehzahl</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveLimits</name>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>A larger current is not commanded; asking for one in a current mode stops</source>
        <translation>Mehr Strom wird nicht gestellt; wer in einem Strommodus mehr verlangt, löst den Stopp aus</translation>
    </message>
    <message>
        <source>Hotter coil</source>
        <translation>Heißere Spule</translation>
    </message>
    <message>
        <source>The board stops when a coil is hotter</source>
        <translation>Das Steuergerät stoppt, wenn eine Spule heißer ist</translation>
    </message>
    <message>
        <source>Excursion</source>
        <translation>Auslenkung</translation>
    </message>
    <message>
        <source>The board stops when it is farther from where it was armed</source>
        <translation>Das Steuergerät stoppt, wenn der Rotor weiter von der Stelle der Freigabe entfernt ist</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>The board stops when it turns faster</source>
        <translation>Das Steuergerät stoppt, wenn der Rotor schneller dreht</translation>
    </message>
    <message>
        <source>Off: not watched (Space)</source>
        <translation>Aus: nicht überwacht (Leertaste)</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>Grenzwert: %1</translation>
    </message>
    <message>
        <source>Enter writes it</source>
        <translation>Die Eingabetaste schreibt ihn</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a limit, nothing was written.</source>
        <translation>„%1“ ist keine Grenze; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Allowed: %1.</source>
        <translation>Erlaubt: %1.</translation>
    </message>
</context>
<context>
    <name>halbench::app::DrivePanel</name>
    <message>
        <source>What the board says of itself</source>
        <translation>Was das Steuergerät über sich sagt</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>&amp;Modus</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Leerlauf</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>D-axis</source>
        <translation>D-Achse</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Idle: no current. Current: torque by hand. Position: holds and follows.
D-axis: current that holds the rotor without turning it (Alt+M)</source>
        <translation>Leerlauf: kein Strom. Strom: Drehmoment von Hand. Position: hält und folgt.
D-Achse: Strom, der den Rotor hält, ohne ihn zu drehen (Alt+M)</translation>
    </message>
    <message>
        <source>Set-point and jog</source>
        <translation>Sollwert und Tippbetrieb</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Los</translation>
    </message>
    <message>
        <source>Sends the set-point (Enter in the field)</source>
        <translation>Sendet den Sollwert (Eingabetaste im Feld)</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Null</translation>
    </message>
    <message>
        <source>Sends the set-point zero</source>
        <translation>Sendet den Sollwert null</translation>
    </message>
    <message>
        <source>Reference generator</source>
        <translation>Sollwertgenerator</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Starts the reference from where the rotor is (Ctrl+Shift+R)</source>
        <translation>Startet den Verlauf dort, wo der Rotor steht (Strg+Umschalt+R)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Ends the reference: a position is held, a current goes to zero (Ctrl+Shift+E)</source>
        <translation>Beendet den Verlauf: eine Position wird gehalten, ein Strom geht auf null (Strg+Umschalt+E)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Limits of the board</source>
        <translation>Grenzwerte des Steuergeräts</translation>
    </message>
    <message>
        <source>Armed, the actuator can move at any moment.</source>
        <translation>Freigegeben kann sich der Aktor jederzeit bewegen.</translation>
    </message>
    <message>
        <source>Keep hands, hair, cables and loose parts away from it. Esc stops it.</source>
        <translation>Halten Sie Hände, Haare, Kabel und lose Teile fern. Esc stoppt ihn.</translation>
    </message>
    <message>
        <source>Arm it</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Now %1</source>
        <translation>Jetzt %1</translation>
    </message>
    <message>
        <source>Arm first; set-points start at zero.</source>
        <translation>Zuerst freigeben; Sollwerte beginnen bei null.</translation>
    </message>
    <message>
        <source>Release the stop</source>
        <translation>Stopp aufheben</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Kein Gerät</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>%1 is running</source>
        <translation>%1 läuft</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>Zustand: %1</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>No current; set-points to zero (Ctrl+Shift+A)</source>
        <translation>Kein Strom; Sollwerte auf null (Strg+Umschalt+A)</translation>
    </message>
    <message>
        <source>Lets the actuator move; set-points start at zero (Ctrl+Shift+A)</source>
        <translation>Lässt den Aktor sich bewegen; Sollwerte beginnen bei null (Strg+Umschalt+A)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>Angle from where it was armed (Enter sends it)</source>
        <translation>Winkel von der Stelle der Freigabe aus (Eingabetaste sendet ihn)</translation>
    </message>
    <message>
        <source>Current (Enter sends it)</source>
        <translation>Strom (Eingabetaste sendet ihn)</translation>
    </message>
    <message>
        <source>Moves up to %1 from where it is.</source>
        <translation>Bewegt sich bis zu %1 von der jetzigen Stelle.</translation>
    </message>
    <message>
        <source>Commands up to %1.</source>
        <translation>Stellt bis zu %1.</translation>
    </message>
    <message>
        <source>That is beyond the limit: the board may stop it.</source>
        <translation>Das liegt jenseits des Grenzwerts: das Steuergerät kann stoppen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a set-point, nothing was sent.</source>
        <translation>„%1“ ist kein Sollwert; es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Allowed: %1.</source>
        <translation>Erlaubt: %1.</translation>
    </message>
</context>
<context>
    <name>halbench::app::FaultWords</name>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Nothing moves until the stop is released and the device armed again.</source>
        <translation>Nichts bewegt sich, bis der Stopp aufgehoben und das Gerät wieder freigegeben ist.</translation>
    </message>
    <message>
        <source>A coil is hotter than its limit</source>
        <translation>Eine Spule ist heißer als ihr Grenzwert</translation>
    </message>
    <message>
        <source>Let the coils cool down; drive with less current or with pauses.</source>
        <translation>Lassen Sie die Spulen abkühlen; fahren Sie mit weniger Strom oder mit Pausen.</translation>
    </message>
    <message>
        <source>More current was asked for than the limit allows</source>
        <translation>Es wurde mehr Strom verlangt, als der Grenzwert erlaubt</translation>
    </message>
    <message>
        <source>Use a smaller set-point or amplitude.</source>
        <translation>Verwenden Sie einen kleineren Sollwert oder eine kleinere Amplitude.</translation>
    </message>
    <message>
        <source>It turned faster than its window allows</source>
        <translation>Der Rotor drehte schneller, als sein Fenster erlaubt</translation>
    </message>
    <message>
        <source>Use less current or a slower reference, or widen the speed window on purpose.</source>
        <translation>Verwenden Sie weniger Strom oder einen langsameren Verlauf, oder erweitern Sie das Drehzahlfenster bewusst.</translation>
    </message>
    <message>
        <source>It moved farther than its window allows</source>
        <translation>Der Rotor bewegte sich weiter, als sein Fenster erlaubt</translation>
    </message>
    <message>
        <source>Use a smaller motion, or widen the excursion window on purpose.</source>
        <translation>Verwenden Sie eine kleinere Bewegung, oder erweitern Sie das Fenster der Auslenkung bewusst.</translation>
    </message>
    <message>
        <source>The measured angle jumped</source>
        <translation>Der gemessene Winkel ist gesprungen</translation>
    </message>
    <message>
        <source>Turn more slowly; look for magnets or iron near the Hall sensors.</source>
        <translation>Drehen Sie langsamer; suchen Sie nach Magneten oder Eisen nahe den Hall-Sensoren.</translation>
    </message>
    <message>
        <source>A Hall sensor does not see the rotor</source>
        <translation>Ein Hall-Sensor sieht den Rotor nicht</translation>
    </message>
    <message>
        <source>Look at sensors and plug, and calibrate the Hall sensors.</source>
        <translation>Prüfen Sie Sensoren und Stecker, und kalibrieren Sie die Hall-Sensoren.</translation>
    </message>
    <message>
        <source>The controller computed a number that is none</source>
        <translation>Der Regler hat eine Zahl berechnet, die keine ist</translation>
    </message>
    <message>
        <source>Write gains that are known to work.</source>
        <translation>Schreiben Sie Reglerparameter, die bekanntermaßen funktionieren.</translation>
    </message>
</context>
<context>
    <name>halbench::app::FieldPanel</name>
    <message>
        <source>&amp;Ideal</source>
        <translation>&amp;Ideal</translation>
    </message>
    <message>
        <source>Field of an ideal Halbach cylinder (Alt+I)</source>
        <translation>Feld eines idealen Halbach-Zylinders (Alt+I)</translation>
    </message>
    <message>
        <source>Se&amp;gmented</source>
        <translation>Se&amp;gmentiert</translation>
    </message>
    <message>
        <source>Field of its separate magnets (Alt+G)</source>
        <translation>Feld seiner einzelnen Magnete (Alt+G)</translation>
    </message>
    <message>
        <source>Meas&amp;ured</source>
        <translation>Geme&amp;ssen</translation>
    </message>
    <message>
        <source>Direction and size that the Hall sensors see (Alt+U)</source>
        <translation>Richtung und Größe, wie die Hall-Sensoren sie sehen (Alt+S)</translation>
    </message>
    <message>
        <source>Shows the rotor of a connected motor with Hall sensors.</source>
        <translation>Zeigt den Rotor eines verbundenen Motors mit Hall-Sensoren.</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainEditor</name>
    <message>
        <source>a number is missing</source>
        <translation>eine Zahl fehlt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Write a number of zero or more</source>
        <translation>Schreiben Sie eine Zahl größer oder gleich null</translation>
    </message>
    <message>
        <source>Proportional K_P</source>
        <translation>Proportional K_P</translation>
    </message>
    <message>
        <source>Integral K_I</source>
        <translation>Integral K_I</translation>
    </message>
    <message>
        <source>Derivative K_D</source>
        <translation>Differenzial K_D</translation>
    </message>
    <message>
        <source>Feed-forward of inertia</source>
        <translation>Vorsteuerung der Trägheit</translation>
    </message>
    <message>
        <source>Feed-forward of damping</source>
        <translation>Vorsteuerung der Dämpfung</translation>
    </message>
    <message>
        <source>Feed-forward of friction</source>
        <translation>Vorsteuerung der Reibung</translation>
    </message>
    <message>
        <source>... in full from speed</source>
        <translation>... voll ab Drehzahl</translation>
    </message>
    <message>
        <source>Friction assist</source>
        <translation>Reibungshilfe</translation>
    </message>
    <message>
        <source>... from an error of</source>
        <translation>... ab einem Fehler von</translation>
    </message>
    <message>
        <source>... below a reference speed of</source>
        <translation>... unter der Führungsdrehzahl</translation>
    </message>
    <message>
        <source>%1 of the board</source>
        <translation>%1 des Steuergeräts</translation>
    </message>
    <message>
        <source>Parallel form, per</source>
        <translation>Parallele Form, je</translation>
    </message>
    <message>
        <source>Unit of the gains</source>
        <translation>Einheit der Reglerparameter</translation>
    </message>
    <message>
        <source>A/rad and A/° differ by 57.3; files and the board use A/rad</source>
        <translation>A/rad und A/° unterscheiden sich um 57,3; Dateien und Steuergerät verwenden A/rad</translation>
    </message>
    <message>
        <source>Feed-forward and friction assist</source>
        <translation>Vorsteuerung und Reibungshilfe</translation>
    </message>
    <message>
        <source>Show the gains that act on the reference</source>
        <translation>Die Parameter zeigen, die auf die Führungsgröße wirken</translation>
    </message>
</context>
<context>
    <name>halbench::app::HelpWindow</name>
    <message>
        <source>Halbench help</source>
        <translation>Hilfe zu Halbench</translation>
    </message>
    <message>
        <source>Help page</source>
        <translation>Hilfeseite</translation>
    </message>
    <message>
        <source>Alt+Left goes back</source>
        <translation>Alt+Links geht zurück</translation>
    </message>
    <message>
        <source>There is no help page &apos;%1&apos; in this program.</source>
        <translation>In diesem Programm gibt es keine Hilfeseite „%1“.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>The page before (Alt+Left)</source>
        <translation>Die vorige Seite (Alt+Links)</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentificationFigures</name>
    <message>
        <source>fit forward</source>
        <translation>Gerade vorwärts</translation>
    </message>
    <message>
        <source>fit reverse</source>
        <translation>Gerade rückwärts</translation>
    </message>
    <message>
        <source>Joint 95 % region of damping and friction</source>
        <translation>Gemeinsamer 95-%-Bereich von Dämpfung und Reibung</translation>
    </message>
    <message>
        <source>95 % joint region</source>
        <translation>gemeinsamer 95-%-Bereich</translation>
    </message>
    <message>
        <source>Steady speed against current amplitude</source>
        <translation>Stationäre Drehzahl über der Stromamplitude</translation>
    </message>
    <message>
        <source>current amplitude</source>
        <translation>Stromamplitude</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>viscous damping c</source>
        <translation>viskose Dämpfung c</translation>
    </message>
    <message>
        <source>Coulomb friction K_f</source>
        <translation>Coulomb-Reibung K_f</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyForm</name>
    <message>
        <source>&amp;From current</source>
        <translation>&amp;Von Strom</translation>
    </message>
    <message>
        <source>&amp;To current</source>
        <translation>&amp;Bis Strom</translation>
    </message>
    <message>
        <source>Ste&amp;p</source>
        <translation>Schri&amp;tt</translation>
    </message>
    <message>
        <source>&amp;Directions</source>
        <translation>&amp;Richtungen</translation>
    </message>
    <message>
        <source>Given inertia &amp;J</source>
        <translation>Bekannte Trägheit &amp;J</translation>
    </message>
    <message>
        <source>Given damping &amp;c</source>
        <translation>Bekannte Dämpfung &amp;c</translation>
    </message>
    <message>
        <source>Given friction &amp;K_f</source>
        <translation>Bekannte Reibung &amp;K_f</translation>
    </message>
    <message>
        <source>Given torque constant φ</source>
        <translation>Bekannte Drehmomentkonstante φ</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Startwert</translation>
    </message>
    <message>
        <source>First steady current of the sweep; well above the breakaway current</source>
        <translation>Erster stationärer Strom der Messreihe; deutlich über dem Losbrechstrom</translation>
    </message>
    <message>
        <source>Last steady current of the sweep, included</source>
        <translation>Letzter stationärer Strom der Messreihe, einschließlich</translation>
    </message>
    <message>
        <source>Distance of the currents</source>
        <translation>Abstand der Ströme</translation>
    </message>
    <message>
        <source>Both ways also tell how friction differs between them</source>
        <translation>Beide Richtungen zeigen auch, wie sich die Reibung zwischen ihnen unterscheidet</translation>
    </message>
    <message>
        <source>Known inertia of all that turns; makes absolute values of ratios. Empty: not known</source>
        <translation>Bekanntes Trägheitsmoment von allem, was sich dreht; macht aus Verhältnissen absolute Werte. Leer: nicht bekannt</translation>
    </message>
    <message>
        <source>Known viscous damping. Empty: not known</source>
        <translation>Bekannte viskose Dämpfung. Leer: nicht bekannt</translation>
    </message>
    <message>
        <source>Known Coulomb friction. Empty: not known</source>
        <translation>Bekannte Coulomb-Reibung. Leer: nicht bekannt</translation>
    </message>
    <message>
        <source>Known torque constant. Empty: not known</source>
        <translation>Bekannte Drehmomentkonstante. Leer: nicht bekannt</translation>
    </message>
    <message>
        <source>Order of the plateaus and resampling; equal seeds give equal results</source>
        <translation>Reihenfolge der Plateaus und Wiederholungsstichproben; gleiche Startwerte geben gleiche Ergebnisse</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>reverse</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>&amp;Advanced</source>
        <translation>&amp;Erweitert</translation>
    </message>
    <message>
        <source>Show what is seldom changed (Alt+A)</source>
        <translation>Zeigen, was selten geändert wird (Alt+E)</translation>
    </message>
    <message>
        <source>Advanced settings</source>
        <translation>Erweiterte Einstellungen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>Berichtigen Sie es, oder lassen Sie es leer</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyPanel</name>
    <message>
        <source>Save as model</source>
        <translation>Als Modell speichern</translation>
    </message>
    <message>
        <source>Model (*.json)</source>
        <translation>Modell (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Excite</source>
        <translation>Anregen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Judge</source>
        <translation>Beurteilen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Finds damping, friction, torque constant and inertia of the motor with their 95 % intervals, by turning it at steady currents and letting it coast.</source>
        <translation>Ermittelt Dämpfung, Reibung, Drehmomentkonstante und Trägheitsmoment des Motors mit ihren 95-%-Intervallen, indem es ihn mit konstanten Strömen dreht und auslaufen lässt.</translation>
    </message>
    <message>
        <source>Start identification</source>
        <translation>Identifikation starten</translation>
    </message>
    <message>
        <source>The rotor turns (Ctrl+Return); Esc stops it</source>
        <translation>Der Rotor dreht sich (Strg+Eingabe); Esc stoppt ihn</translation>
    </message>
    <message>
        <source>Load model…</source>
        <translation>Modell laden …</translation>
    </message>
    <message>
        <source>Show a model that was saved before</source>
        <translation>Ein früher gespeichertes Modell zeigen</translation>
    </message>
    <message>
        <source>Tune with this</source>
        <translation>Damit auslegen</translation>
    </message>
    <message>
        <source>Go on to the gains for this motor</source>
        <translation>Weiter zu den Reglerparametern für diesen Motor</translation>
    </message>
    <message>
        <source>Save as model…</source>
        <translation>Als Modell speichern …</translation>
    </message>
    <message>
        <source>Write the file that the program&apos;s tune and analyse read</source>
        <translation>Die Datei schreiben, die tune und analyse des Programms lesen</translation>
    </message>
    <message>
        <source>Identify again</source>
        <translation>Neu identifizieren</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next one</source>
        <translation>Zurück zu den Einstellungen; dieses Ergebnis bleibt bis zum nächsten</translation>
    </message>
    <message>
        <source>Plateaus as they are completed; the fit comes afterwards</source>
        <translation>Plateaus, wie sie fertig werden; die Anpassung folgt danach</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifizieren</translation>
    </message>
    <message>
        <source>Identifying</source>
        <translation>Identifikation</translation>
    </message>
    <message>
        <source>The rotor turns: plateaus and coast-downs</source>
        <translation>Der Rotor dreht sich: Plateaus und Ausläufe</translation>
    </message>
    <message>
        <source>Fitting all of the motion</source>
        <translation>Die gesamte Bewegung wird angepasst</translation>
    </message>
    <message>
        <source>The identification was cancelled; everything is as it was before.</source>
        <translation>Die Identifikation wurde abgebrochen; alles ist, wie es war.</translation>
    </message>
    <message>
        <source>Load model</source>
        <translation>Modell laden</translation>
    </message>
    <message>
        <source>Identify again when the motor has changed since.</source>
        <translation>Identifizieren Sie neu, wenn sich der Motor seither verändert hat.</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyResultView</name>
    <message>
        <source>Identified values</source>
        <translation>Identifizierte Werte</translation>
    </message>
    <message>
        <source>Fit and residuals</source>
        <translation>Anpassung und Residuen</translation>
    </message>
    <message>
        <source>Joint region</source>
        <translation>Gemeinsamer Bereich</translation>
    </message>
    <message>
        <source>Steady speed against current, and what the fit leaves over</source>
        <translation>Stationäre Drehzahl über dem Strom, und was die Anpassung übrig lässt</translation>
    </message>
    <message>
        <source>Where damping and friction lie together with 95 % probability</source>
        <translation>Wo Dämpfung und Reibung mit 95 % Wahrscheinlichkeit gemeinsam liegen</translation>
    </message>
    <message>
        <source>Pictures of the identification</source>
        <translation>Bilder der Identifikation</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Picture (*.svg *.png)</source>
        <translation>Bild (*.svg *.png)</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyWords</name>
    <message>
        <source>identified</source>
        <translation>identifiziert</translation>
    </message>
    <message>
        <source>given</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>not identifiable</source>
        <translation>nicht identifizierbar</translation>
    </message>
    <message>
        <source>Angle and current alone show only quotients; see below what would supply it</source>
        <translation>Winkel und Strom allein zeigen nur Quotienten; unten steht, was fehlt</translation>
    </message>
    <message>
        <source>K_f/φ, breakaway current</source>
        <translation>K_f/φ, Losbrechstrom</translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>in beide Richtungen</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>in reverse</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>The rotor will turn %1, about %2 turns in all, at up to %3 rad/s (%4 r/min), for %5 minutes of device time.</source>
        <translation>Der Rotor dreht sich %1, insgesamt etwa %2 Umdrehungen, mit bis zu %3 rad/s (%4 1/min), %5 Minuten Gerätezeit lang.</translation>
    </message>
    <message>
        <source>Current up to %1 A, coils up to %2 °C.</source>
        <translation>Strom bis %1 A, Spulen bis %2 °C.</translation>
    </message>
    <message>
        <source>Current up to %1 A; it waits for the coils to cool where they would come near %2 °C.</source>
        <translation>Strom bis %1 A; wo die Spulen nahe %2 °C kämen, wird gewartet, bis sie abkühlen.</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 rad/s; gains and limits are restored whatever happens.</source>
        <translation>Das Steuergerät beendet die Bewegung bei %1 rad/s; Reglerparameter und Grenzwerte werden in jedem Fall wiederhergestellt.</translation>
    </message>
    <message>
        <source>viscous damping c</source>
        <translation>viskose Dämpfung c</translation>
    </message>
    <message>
        <source>Coulomb friction K_f</source>
        <translation>Coulomb-Reibung K_f</translation>
    </message>
    <message>
        <source>torque constant φ</source>
        <translation>Drehmomentkonstante φ</translation>
    </message>
    <message>
        <source>inertia J</source>
        <translation>Trägheitsmoment J</translation>
    </message>
    <message>
        <source>asymmetry of the friction</source>
        <translation>Unsymmetrie der Reibung</translation>
    </message>
    <message>
        <source>Good: nothing speaks against the model</source>
        <translation>Gut: nichts spricht gegen das Modell</translation>
    </message>
    <message>
        <source>Doubtful: look at the findings before you rely on it</source>
        <translation>Zweifelhaft: lesen Sie die Befunde, bevor Sie sich darauf verlassen</translation>
    </message>
    <message>
        <source>Refused: there is no result to rely on</source>
        <translation>Abgelehnt: es gibt kein verlässliches Ergebnis</translation>
    </message>
    <message>
        <source>Not identifiable: %1. Angle and current show quotients only; one of these supplies the scale:</source>
        <translation>Nicht identifizierbar: %1. Winkel und Strom zeigen nur Quotienten; eines davon liefert den Maßstab:</translation>
    </message>
    <message>
        <source>• the inertia J of all that turns (drawing, or weighed): c, K_f and φ follow</source>
        <translation>• das Trägheitsmoment J von allem, was sich dreht (Zeichnung oder gewogen): c, K_f und φ folgen</translation>
    </message>
    <message>
        <source>• the torque constant φ (data sheet): J, c and K_f follow</source>
        <translation>• die Drehmomentkonstante φ (Datenblatt): J, c und K_f folgen</translation>
    </message>
    <message>
        <source>• no data at all: fix a part of known inertia to the rotor and identify again</source>
        <translation>• gar keine Daten: befestigen Sie ein Teil bekannter Trägheit am Rotor und identifizieren Sie erneut</translation>
    </message>
    <message>
        <source>• the torque constant φ (data sheet): c and K_f follow, J does not</source>
        <translation>• die Drehmomentkonstante φ (Datenblatt): c und K_f folgen, J nicht</translation>
    </message>
    <message>
        <source>• run-ups and coast-downs besides the steady plateaus: then J or φ is enough</source>
        <translation>• Hoch- und Ausläufe neben den stationären Plateaus: dann genügt J oder φ</translation>
    </message>
    <message>
        <source>Tuning works without: it needs the quotients alone.</source>
        <translation>Die Auslegung kommt ohne aus: sie braucht nur die Quotienten.</translation>
    </message>
    <message>
        <source>Device %1, firmware %2</source>
        <translation>Gerät %1, Firmware %2</translation>
    </message>
    <message>
        <source>overrides %1</source>
        <translation>Abweichungen %1</translation>
    </message>
    <message>
        <source>Device not known</source>
        <translation>Gerät nicht bekannt</translation>
    </message>
    <message>
        <source>Halbench %1</source>
        <translation>Halbench %1</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>Startwert %1</translation>
    </message>
    <message>
        <source>started %1</source>
        <translation>begonnen %1</translation>
    </message>
    <message>
        <source>%1 minutes of device time, coils up to %2 °C</source>
        <translation>%1 Minuten Gerätezeit, Spulen bis %2 °C</translation>
    </message>
    <message>
        <source>device not known</source>
        <translation>Gerät nicht bekannt</translation>
    </message>
    <message>
        <source>From the project: identified in virtual time, device %1.</source>
        <translation>Aus dem Projekt: in virtueller Zeit identifiziert, Gerät %1.</translation>
    </message>
    <message>
        <source>From the project: identified %1, device %2.</source>
        <translation>Aus dem Projekt: identifiziert %1, Gerät %2.</translation>
    </message>
</context>
<context>
    <name>halbench::app::JogRow</name>
    <message>
        <source>− Back</source>
        <translation>− Zurück</translation>
    </message>
    <message>
        <source>Moves backward while it is held (hold Space)</source>
        <translation>Bewegt sich rückwärts, solange gedrückt (Leertaste halten)</translation>
    </message>
    <message>
        <source>Forward +</source>
        <translation>Vor +</translation>
    </message>
    <message>
        <source>Moves forward while it is held (hold Space)</source>
        <translation>Bewegt sich vorwärts, solange gedrückt (Leertaste halten)</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>Tippdrehzahl</translation>
    </message>
    <message>
        <source>How fast it moves while a button is held</source>
        <translation>Wie schnell er sich bewegt, solange eine Taste gedrückt ist</translation>
    </message>
    <message>
        <source>Jog current</source>
        <translation>Tippstrom</translation>
    </message>
    <message>
        <source>The current while a button is held</source>
        <translation>Der Strom, solange eine Taste gedrückt ist</translation>
    </message>
</context>
<context>
    <name>halbench::app::LinkPanel</name>
    <message>
        <source>Link statistics</source>
        <translation>Statistik der Verbindung</translation>
    </message>
    <message>
        <source>Packets per second of device time, packets lost and damaged, median and worst answer time</source>
        <translation>Pakete je Sekunde Gerätezeit, verlorene und beschädigte Pakete, mittlere und längste Antwortzeit</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Steuergerät</translation>
    </message>
    <message>
        <source>Firmware of the board and its state in words</source>
        <translation>Firmware des Steuergeräts und sein Zustand in Worten</translation>
    </message>
    <message>
        <source>link: connecting</source>
        <translation>Verbindung: wird aufgebaut</translation>
    </message>
    <message>
        <source>link: none</source>
        <translation>Verbindung: keine</translation>
    </message>
    <message>
        <source>link: %1 packets/s, %2 lost, %3 damaged, %4 ms (worst %5 ms)</source>
        <translation>Verbindung: %1 Pakete/s, %2 verloren, %3 beschädigt, %4 ms (längste %5 ms)</translation>
    </message>
    <message>
        <source>board: firmware %1%2</source>
        <translation>Steuergerät: Firmware %1%2</translation>
    </message>
    <message>
        <source>, %1</source>
        <translation>, %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::LivePlateaus</name>
    <message>
        <source>line forward</source>
        <translation>Gerade vorwärts</translation>
    </message>
    <message>
        <source>line reverse</source>
        <translation>Gerade rückwärts</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>plateaus so far</source>
        <translation>Plateaus bisher</translation>
    </message>
    <message>
        <source>Steady speed against current amplitude</source>
        <translation>Stationäre Drehzahl über der Stromamplitude</translation>
    </message>
    <message>
        <source>current amplitude</source>
        <translation>Stromamplitude</translation>
    </message>
</context>
<context>
    <name>halbench::app::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Connect the s&amp;imulated motor</source>
        <translation>Den s&amp;imulierten Motor verbinden</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Reset the arrangement</source>
        <translation>An&amp;ordnung zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;System</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Spra&amp;che</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Help on this panel</source>
        <translation>&amp;Hilfe zu diesem Bereich</translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation>Die Sprache wechselt beim nächsten Start.</translation>
    </message>
    <message>
        <source>The project of the last session, which has no name yet, is open again.</source>
        <translation>Das Projekt der letzten Sitzung, das noch keinen Namen hat, ist wieder geöffnet.</translation>
    </message>
    <message>
        <source>Save it under a name to keep it.</source>
        <translation>Speichern Sie es unter einem Namen, um es zu behalten.</translation>
    </message>
    <message>
        <source>unnamed project</source>
        <translation>Projekt ohne Namen</translation>
    </message>
    <message>
        <source>%1[*] — Halbench</source>
        <translation>%1[*] — Halbench</translation>
    </message>
    <message>
        <source>Not everything of the project could be read: %1</source>
        <translation>Nicht alles aus dem Projekt war lesbar: %1</translation>
    </message>
    <message>
        <source>It stays in the file as it is; the rest is open.</source>
        <translation>Es bleibt in der Datei, wie es ist; der Rest ist geöffnet.</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorPanel</name>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Weitere Werkzeuge</translation>
    </message>
    <message>
        <source>What the device sends to the plots</source>
        <translation>Was das Gerät an die Diagramme sendet</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>no signals</source>
        <translation>keine Signale</translation>
    </message>
    <message>
        <source>time passes only while a procedure runs</source>
        <translation>Zeit vergeht nur, solange ein Vorgang läuft</translation>
    </message>
    <message>
        <source>%1 signals, %2 Hz, %3 rows lost</source>
        <translation>%1 Signale, %2 Hz, %3 Zeilen verloren</translation>
    </message>
</context>
<context>
    <name>halbench::app::NotesPanel</name>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Your notes on this motor; saved with the project</source>
        <translation>Ihre Notizen zu diesem Motor; sie werden mit dem Projekt gespeichert</translation>
    </message>
    <message>
        <source>Notes on this motor; saved with the project.</source>
        <translation>Notizen zu diesem Motor; werden mit dem Projekt gespeichert.</translation>
    </message>
</context>
<context>
    <name>halbench::app::ParametersPanel</name>
    <message>
        <source>Preset</source>
        <translation>Parametersatz</translation>
    </message>
    <message>
        <source>A named set of parameters, shipped or your own</source>
        <translation>Ein benannter Satz von Parametern, mitgeliefert oder eigener</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Edits the rows as the preset says; nothing is written yet</source>
        <translation>Bearbeitet die Zeilen nach dem Parametersatz; noch wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Name of the new preset</source>
        <translation>Name des neuen Parametersatzes</translation>
    </message>
    <message>
        <source>name of a preset</source>
        <translation>Name eines Parametersatzes</translation>
    </message>
    <message>
        <source>Keeps the edited column under this name (Enter)</source>
        <translation>Behält die bearbeitete Spalte unter diesem Namen (Eingabetaste)</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keeps the edited column as a preset (Enter in the name)</source>
        <translation>Behält die bearbeitete Spalte als Parametersatz (Eingabetaste im Namen)</translation>
    </message>
    <message>
        <source>Save in the device</source>
        <translation>Im Gerät speichern</translation>
    </message>
    <message>
        <source>Stores what the device runs with for the next power-up; writing is another act</source>
        <translation>Speichert, womit das Gerät läuft, für das nächste Einschalten; Schreiben ist eine andere Handlung</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) written and read back.</source>
        <translation>
            <numerusform>%n Wert geschrieben und zurückgelesen.</numerusform>
            <numerusform>%n Werte geschrieben und zurückgelesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>They are lost at power-down until they are saved in the device.</source>
        <translation>Beim Ausschalten gehen sie verloren, wenn sie nicht im Gerät gespeichert sind.</translation>
    </message>
    <message>
        <source>A simulated device is new every time and has nothing to store in.</source>
        <translation>Ein simuliertes Gerät ist jedes Mal neu und kann nichts speichern.</translation>
    </message>
    <message>
        <source>Keep the values as a preset, or serve the device to have one that lasts.</source>
        <translation>Behalten Sie die Werte als Parametersatz, oder stellen Sie das Gerät mit „serve“ bereit, damit es bleibt.</translation>
    </message>
    <message>
        <source>Saved in the device.</source>
        <translation>Im Gerät gespeichert.</translation>
    </message>
    <message>
        <source>It starts with these values at the next power-up.</source>
        <translation>Beim nächsten Einschalten beginnt es mit diesen Werten.</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>%1 laden</translation>
    </message>
    <message>
        <source>Not taken from the preset: %1</source>
        <translation>Nicht aus dem Parametersatz übernommen: %1</translation>
    </message>
    <message>
        <source>This device does not have these parameters, or not with these values.</source>
        <translation>Dieses Gerät hat diese Parameter nicht, oder nicht mit diesen Werten.</translation>
    </message>
    <message>
        <source>Kept as %1.</source>
        <translation>Als %1 behalten.</translation>
    </message>
</context>
<context>
    <name>halbench::app::Preflight</name>
    <message>
        <source>The rotor may turn now</source>
        <translation>Der Rotor darf sich jetzt drehen</translation>
    </message>
    <message>
        <source>A real motor moves only with your consent</source>
        <translation>Ein echter Motor bewegt sich nur mit Ihrer Zustimmung</translation>
    </message>
    <message>
        <source>Checks before the start</source>
        <translation>Prüfungen vor dem Start</translation>
    </message>
</context>
<context>
    <name>halbench::app::PreflightWords</name>
    <message>
        <source>No device is connected</source>
        <translation>Kein Gerät ist verbunden</translation>
    </message>
    <message>
        <source>Connect one in the Devices panel</source>
        <translation>Verbinden Sie eines im Bereich Geräte</translation>
    </message>
    <message>
        <source>Another procedure runs</source>
        <translation>Ein anderer Vorgang läuft</translation>
    </message>
    <message>
        <source>Wait for its end or cancel it</source>
        <translation>Warten Sie auf sein Ende, oder brechen Sie ihn ab</translation>
    </message>
    <message>
        <source>The device is connected and free</source>
        <translation>Das Gerät ist verbunden und frei</translation>
    </message>
    <message>
        <source>Fault: %1</source>
        <translation>Fehler: %1</translation>
    </message>
    <message>
        <source>Remove its cause, then re-arm on purpose in the Drive panel</source>
        <translation>Beseitigen Sie die Ursache, und heben Sie dann den Stopp bewusst im Bereich Antrieb auf</translation>
    </message>
    <message>
        <source>The stop is latched</source>
        <translation>Der Stopp ist verriegelt</translation>
    </message>
    <message>
        <source>Release it with the STOP control</source>
        <translation>Heben Sie ihn mit der STOPP-Taste auf</translation>
    </message>
    <message>
        <source>The device is armed by hand</source>
        <translation>Das Gerät ist von Hand freigegeben</translation>
    </message>
    <message>
        <source>Disarm it first</source>
        <translation>Sperren Sie es zuerst</translation>
    </message>
    <message>
        <source>No fault, not stopped, not armed</source>
        <translation>Kein Fehler, nicht gestoppt, nicht freigegeben</translation>
    </message>
    <message>
        <source>Coil temperature not known yet; the procedure measures it first</source>
        <translation>Spulentemperatur noch nicht bekannt; der Vorgang misst sie zuerst</translation>
    </message>
    <message>
        <source>Coils %1 now</source>
        <translation>Spulen jetzt %1</translation>
    </message>
    <message>
        <source>%1, at most %2 by forecast</source>
        <translation>%1, nach Vorhersage höchstens %2</translation>
    </message>
    <message>
        <source>%1; the run waits where they would come near %2</source>
        <translation>%1; der Ablauf wartet, wo sie nahe %2 kämen</translation>
    </message>
    <message>
        <source>Use less current or fewer steps; %1 must not be reached</source>
        <translation>Verwenden Sie weniger Strom oder weniger Schritte; %1 darf nicht erreicht werden</translation>
    </message>
    <message>
        <source>Simulated: nothing can be hit</source>
        <translation>Simuliert: nichts kann anstoßen</translation>
    </message>
    <message>
        <source>The rotor is free to turn and nobody touches it</source>
        <translation>Der Rotor ist frei drehbar, und niemand berührt ihn</translation>
    </message>
    <message>
        <source>Look, then say so below</source>
        <translation>Sehen Sie nach, und bestätigen Sie es unten</translation>
    </message>
</context>
<context>
    <name>halbench::app::ProjectMenu</name>
    <message>
        <source>&amp;New project</source>
        <translation>&amp;Neues Projekt</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>Projekt ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zu&amp;letzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>Projekt &amp;speichern</translation>
    </message>
    <message>
        <source>Save project &amp;as…</source>
        <translation>Projekt speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Halbench project (*.toml)</source>
        <translation>Halbench-Projekt (*.toml)</translation>
    </message>
    <message>
        <source>Unsaved work of %1 was recovered; save it to keep it.</source>
        <translation>Ungesicherte Arbeit an %1 wurde wiederhergestellt; speichern Sie sie, um sie zu behalten.</translation>
    </message>
    <message>
        <source>Save project as</source>
        <translation>Projekt speichern unter</translation>
    </message>
    <message>
        <source>No project was opened yet</source>
        <translation>Es wurde noch kein Projekt geöffnet</translation>
    </message>
</context>
<context>
    <name>halbench::app::ProjectWork</name>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>gains</source>
        <translation>Reglerwerte</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordPanel</name>
    <message>
        <source>Folder of recordings</source>
        <translation>Ordner der Aufzeichnungen</translation>
    </message>
    <message>
        <source>Made when it does not exist</source>
        <translation>Wird angelegt, wenn es ihn nicht gibt</translation>
    </message>
    <message>
        <source>Name of the recording</source>
        <translation>Name der Aufzeichnung</translation>
    </message>
    <message>
        <source>device and date</source>
        <translation>Gerät und Datum</translation>
    </message>
    <message>
        <source>Without ending; empty: device and date</source>
        <translation>Ohne Endung; leer: Gerät und Datum</translation>
    </message>
    <message>
        <source>Rows per second</source>
        <translation>Zeilen je Sekunde</translation>
    </message>
    <message>
        <source>At most as many as the device sends</source>
        <translation>Höchstens so viele, wie das Gerät sendet</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Device time from the first row to the last</source>
        <translation>Gerätezeit von der ersten bis zur letzten Zeile</translation>
    </message>
    <message>
        <source>Rows written</source>
        <translation>Geschriebene Zeilen</translation>
    </message>
    <message>
        <source>On the disk</source>
        <translation>Auf der Festplatte</translation>
    </message>
    <message>
        <source>Rows missing</source>
        <translation>Fehlende Zeilen</translation>
    </message>
    <message>
        <source>Lost on the link, or the disk did not keep up; marked in the file</source>
        <translation>Auf der Verbindung verloren, oder die Festplatte kam nicht nach; in der Datei gekennzeichnet</translation>
    </message>
    <message>
        <source>Note of the marker</source>
        <translation>Notiz der Marke</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>What the marker says (Enter marks)</source>
        <translation>Was die Marke sagt (Eingabetaste markiert)</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>Marks this moment in the recording (Enter in the note)</source>
        <translation>Markiert diesen Augenblick in der Aufzeichnung (Eingabetaste in der Notiz)</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Completes the file (Ctrl+R)</source>
        <translation>Schließt die Datei ab (Strg+R)</translation>
    </message>
    <message>
        <source>Writes what is measured to a file (Ctrl+R)</source>
        <translation>Schreibt, was gemessen wird, in eine Datei (Strg+R)</translation>
    </message>
    <message>
        <source>%1 rows in %2</source>
        <translation>%1 Zeilen in %2</translation>
    </message>
    <message>
        <source>What was measured, with its units; the sidecar beside it has the rest.</source>
        <translation>Was gemessen wurde, mit Einheiten; die Begleitdatei daneben enthält das Übrige.</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingControl</name>
    <message>
        <source>There is nothing to record.</source>
        <translation>Es gibt nichts aufzuzeichnen.</translation>
    </message>
    <message>
        <source>Connect a device first.</source>
        <translation>Verbinden Sie zuerst ein Gerät.</translation>
    </message>
    <message>
        <source>%1 exists already.</source>
        <translation>%1 gibt es bereits.</translation>
    </message>
    <message>
        <source>Choose another name; recordings are not overwritten.</source>
        <translation>Wählen Sie einen anderen Namen; Aufzeichnungen werden nicht überschrieben.</translation>
    </message>
    <message>
        <source>%1. What was written until then is in %2.</source>
        <translation>%1. Was bis dahin geschrieben wurde, steht in %2.</translation>
    </message>
</context>
<context>
    <name>halbench::app::ReferenceForm</name>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Height of the step or of one stair, amplitude of sine and chirp, rms of a multisine, end of a ramp (0: no end)</source>
        <translation>Höhe des Sprungs oder einer Stufe, Amplitude von Sinus und Chirp, Effektivwert eines Multisinus, Ende einer Rampe (0: ohne Ende)</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>How fast the ramp rises; negative: backward</source>
        <translation>Wie schnell die Rampe steigt; negativ: rückwärts</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Of the sine; the first one of chirp and multisine</source>
        <translation>Des Sinus; die erste von Chirp und Multisinus</translation>
    </message>
    <message>
        <source>Last frequency</source>
        <translation>Letzte Frequenz</translation>
    </message>
    <message>
        <source>Where chirp and multisine end</source>
        <translation>Wo Chirp und Multisinus enden</translation>
    </message>
    <message>
        <source>Time of a stair</source>
        <translation>Zeit einer Stufe</translation>
    </message>
    <message>
        <source>How long every stair is held</source>
        <translation>Wie lange jede Stufe gehalten wird</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Stairs of a staircase, lines of a multisine (at most 32)</source>
        <translation>Stufen einer Treppe, Linien eines Multisinus (höchstens 32)</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Phases of the multisine; 0: those that keep its peak low</source>
        <translation>Phasen des Multisinus; 0: die mit kleinem Spitzenwert</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Grundwert</translation>
    </message>
    <message>
        <source>Constant motion, or constant current, added to the shape</source>
        <translation>Konstante Bewegung oder konstanter Strom, zur Form addiert</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Then a position is held and a current goes to zero</source>
        <translation>Danach wird eine Position gehalten, und ein Strom geht auf null</translation>
    </message>
    <message>
        <source>Time of a plateau</source>
        <translation>Zeit eines Plateaus</translation>
    </message>
    <message>
        <source>How long every current is held</source>
        <translation>Wie lange jeder Strom gehalten wird</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>Treppe</translation>
    </message>
    <message>
        <source>Chirp</source>
        <translation>Chirp</translation>
    </message>
    <message>
        <source>Multisine</source>
        <translation>Multisinus</translation>
    </message>
    <message>
        <source>Speed plateaus</source>
        <translation>Drehzahlplateaus</translation>
    </message>
    <message>
        <source>Shape of the reference</source>
        <translation>Form des Verlaufs</translation>
    </message>
    <message>
        <source>What the board&apos;s generator adds to the set-point</source>
        <translation>Was der Generator des Steuergeräts zum Sollwert addiert</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Currents of the plateaus in ampere</source>
        <translation>Ströme der Plateaus in Ampere</translation>
    </message>
    <message>
        <source>Up to 32 currents in A, one after the other, with spaces or semicolons between</source>
        <translation>Bis zu 32 Ströme in A, nacheinander, mit Leerzeichen oder Semikolon dazwischen</translation>
    </message>
    <message>
        <source>Currents (A)</source>
        <translation>Ströme (A)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a current.</source>
        <translation>„%1“ ist kein Strom.</translation>
    </message>
    <message>
        <source>Write currents in A, e.g. 1.6; 2; 2.4.</source>
        <translation>Schreiben Sie Ströme in A, z. B. 1,6; 2; 2,4.</translation>
    </message>
    <message>
        <source>There are %1 plateaus.</source>
        <translation>Es sind %1 Plateaus.</translation>
    </message>
    <message>
        <source>The board takes 1 to 32.</source>
        <translation>Das Steuergerät nimmt 1 bis 32.</translation>
    </message>
</context>
<context>
    <name>halbench::app::SignalTree</name>
    <message>
        <source>Signals of the device</source>
        <translation>Signale des Geräts</translation>
    </message>
    <message>
        <source>A tick plots a signal (Enter or Space); drag it onto a plot</source>
        <translation>Ein Haken zeichnet ein Signal (Eingabetaste oder Leertaste); ziehen Sie es auf ein Diagramm</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>other</source>
        <translation>übrige</translation>
    </message>
</context>
<context>
    <name>halbench::app::TopBar</name>
    <message>
        <source>Arrange the panels for %1 (%2)</source>
        <translation>Bereiche zum %1 anordnen (%2)</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Write what is measured to a file, or end that (Ctrl+R)</source>
        <translation>Was gemessen wird, in eine Datei schreiben, oder das beenden (Strg+R)</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneForm</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>Berichtigen Sie es, oder lassen Sie es leer</translation>
    </message>
    <message>
        <source>Gains &amp;by</source>
        <translation>Reglerparameter &amp;aus</translation>
    </message>
    <message>
        <source>Where the gains come from</source>
        <translation>Woher die Reglerparameter kommen</translation>
    </message>
    <message>
        <source>A design method, a shipped preset, or what the device has</source>
        <translation>Ein Entwurfsverfahren, ein mitgelieferter Parametersatz, oder was das Gerät hat</translation>
    </message>
    <message>
        <source>Method: %1</source>
        <translation>Verfahren: %1</translation>
    </message>
    <message>
        <source>Preset: %1</source>
        <translation>Parametersatz: %1</translation>
    </message>
    <message>
        <source>On the device now</source>
        <translation>Jetzt im Gerät</translation>
    </message>
    <message>
        <source>the gains that run now</source>
        <translation>die Reglerparameter, die jetzt laufen</translation>
    </message>
    <message>
        <source>Edited by hand</source>
        <translation>Von Hand bearbeitet</translation>
    </message>
    <message>
        <source>the numbers below</source>
        <translation>die Zahlen unten</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Bandwidth</source>
        <translation>Bandbreite</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>What the loop shall have; empty: the method&apos;s default</source>
        <translation>Was der Regelkreis haben soll; leer: die Vorgabe des Verfahrens</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneNumberWords</name>
    <message>
        <source>infinite</source>
        <translation>unendlich</translation>
    </message>
    <message>
        <source>%1 overshoot, settled after %2</source>
        <translation>%1 Überschwingen, eingeschwungen nach %2</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>Geschlossener Kreis</translation>
    </message>
    <message>
        <source>Poles of the sampled loop with the device&apos;s delay</source>
        <translation>Pole des Abtastregelkreises mit der Totzeit des Geräts</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stabil</translation>
    </message>
    <message>
        <source>UNSTABLE</source>
        <translation>INSTABIL</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Amplitudenreserve</translation>
    </message>
    <message>
        <source>Factor on the gain that makes the loop unstable; at least 2 is usual</source>
        <translation>Faktor auf die Verstärkung, der den Kreis instabil macht; üblich sind mindestens 2</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>At the gain crossover; at least 30° is usual</source>
        <translation>Bei der Durchtrittsfrequenz; üblich sind mindestens 30°</translation>
    </message>
    <message>
        <source>… of 95 % of the motors</source>
        <translation>… für 95 % der Motoren</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>5th percentile over motors drawn from the identified uncertainty</source>
        <translation>5. Perzentil über Motoren aus der identifizierten Unsicherheit</translation>
    </message>
    <message>
        <source>Unstable motors</source>
        <translation>Instabile Motoren</translation>
    </message>
    <message>
        <source>Share of the motors that the data allow which this loop makes unstable</source>
        <translation>Anteil der nach den Daten möglichen Motoren, die dieser Kreis instabil macht</translation>
    </message>
    <message>
        <source>Gain crossover</source>
        <translation>Durchtrittsfrequenz</translation>
    </message>
    <message>
        <source>Where the open loop has the gain 1</source>
        <translation>Wo der offene Kreis die Verstärkung 1 hat</translation>
    </message>
    <message>
        <source>Delay margin</source>
        <translation>Totzeitreserve</translation>
    </message>
    <message>
        <source>Dead time that uses up the phase margin</source>
        <translation>Totzeit, die die Phasenreserve aufbraucht</translation>
    </message>
    <message>
        <source>Modulus margin</source>
        <translation>Modulreserve</translation>
    </message>
    <message>
        <source>Smallest distance of the open loop from -1; at least 0.5 is usual</source>
        <translation>Kleinster Abstand des offenen Kreises von -1; üblich sind mindestens 0,5</translation>
    </message>
    <message>
        <source>Largest K_P</source>
        <translation>Größtes K_P</translation>
    </message>
    <message>
        <source>Above it the sampled loop is unstable</source>
        <translation>Darüber ist der Abtastregelkreis instabil</translation>
    </message>
    <message>
        <source>Friction band at rest</source>
        <translation>Reibungsband in Ruhe</translation>
    </message>
    <message>
        <source>Friction may hold the rotor this far from its reference</source>
        <translation>So weit kann Reibung den Rotor von der Führungsgröße fernhalten</translation>
    </message>
    <message>
        <source>Linear step</source>
        <translation>Linearer Sprung</translation>
    </message>
    <message>
        <source>Small steps, without friction and current limit</source>
        <translation>Kleine Sprünge, ohne Reibung und Stromgrenze</translation>
    </message>
    <message>
        <source>Step of 100°</source>
        <translation>Sprung um 100°</translation>
    </message>
    <message>
        <source>With friction and current limit</source>
        <translation>Mit Reibung und Stromgrenze</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneNumbers</name>
    <message>
        <source>Prediction</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Vorgeschlagen</translation>
    </message>
    <message>
        <source>On the device</source>
        <translation>Im Gerät</translation>
    </message>
    <message>
        <source>Predicted figures</source>
        <translation>Vorhergesagte Kennzahlen</translation>
    </message>
</context>
<context>
    <name>halbench::app::TunePanel</name>
    <message>
        <source>Verification: %1</source>
        <translation>Nachweis: %1</translation>
    </message>
    <message>
        <source>No motor to tune yet</source>
        <translation>Noch kein Motor zum Auslegen</translation>
    </message>
    <message>
        <source>Gains are designed for an identified motor, with everything that is predicted of them, and proved by a move before they stay.</source>
        <translation>Reglerparameter werden für einen identifizierten Motor entworfen, mit allem, was von ihnen vorhergesagt wird, und durch eine Bewegung nachgewiesen, bevor sie bleiben.</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>Den Motor identifizieren</translation>
    </message>
    <message>
        <source>Apply and verify</source>
        <translation>Übernehmen und nachweisen</translation>
    </message>
    <message>
        <source>One transaction, then a step of 29° that must go as predicted; Esc stops it</source>
        <translation>Ein Vorgang, dann ein Sprung um 29°, der wie vorhergesagt ablaufen muss; Esc stoppt ihn</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>The new gains stay until the device is switched off</source>
        <translation>Die neuen Reglerparameter gelten, bis das Gerät ausgeschaltet wird</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>The gains from before run again</source>
        <translation>Die vorigen Reglerparameter laufen wieder</translation>
    </message>
    <message>
        <source>Save gains…</source>
        <translation>Reglerparameter speichern …</translation>
    </message>
    <message>
        <source>Write the file that the program&apos;s analyse reads</source>
        <translation>Die Datei schreiben, die analyse des Programms liest</translation>
    </message>
    <message>
        <source>Step of 100°</source>
        <translation>Sprung um 100°</translation>
    </message>
    <message>
        <source>Small step</source>
        <translation>Kleiner Sprung</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Nachweis</translation>
    </message>
    <message>
        <source>Predictions</source>
        <translation>Vorhersagen</translation>
    </message>
    <message>
        <source>Identified motor (SI, 95 %): %1</source>
        <translation>Identifizierter Motor (SI, 95 %): %1</translation>
    </message>
    <message>
        <source>Good: robustly stable</source>
        <translation>Gut: robust stabil</translation>
    </message>
    <message>
        <source>Doubtful: read the warnings before you apply it</source>
        <translation>Zweifelhaft: lesen Sie die Warnungen, bevor Sie es übernehmen</translation>
    </message>
    <message>
        <source>Refused: this loop is unstable</source>
        <translation>Abgelehnt: dieser Kreis ist instabil</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Writing the gains</source>
        <translation>Die Reglerparameter werden geschrieben</translation>
    </message>
    <message>
        <source>Cancelled; the gains from before run again.</source>
        <translation>Abgebrochen; die vorigen Reglerparameter laufen wieder.</translation>
    </message>
    <message>
        <source>Applied, and the verification move went as predicted.</source>
        <translation>Übernommen, und der Nachweis verlief wie vorhergesagt.</translation>
    </message>
    <message>
        <source>Keep the new gains, or restore those from before.</source>
        <translation>Behalten Sie die neuen Reglerparameter, oder setzen Sie auf die vorigen zurück.</translation>
    </message>
    <message>
        <source>Not kept, the gains from before run again: %1</source>
        <translation>Nicht behalten, die vorigen Reglerparameter laufen wieder: %1</translation>
    </message>
    <message>
        <source>The gains from before run again.</source>
        <translation>Die vorigen Reglerparameter laufen wieder.</translation>
    </message>
    <message>
        <source>Save gains</source>
        <translation>Reglerparameter speichern</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>Reglerparameter (*.json)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Picture (*.svg *.png)</source>
        <translation>Bild (*.svg *.png)</translation>
    </message>
    <message>
        <source>From the project: gains by %1.</source>
        <translation>Aus dem Projekt: Reglerwerte nach %1.</translation>
    </message>
    <message>
        <source>Choose a method to design anew for the motor as it is now.</source>
        <translation>Wählen Sie ein Verfahren, um sie für den Motor von heute neu zu entwerfen.</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuningFigures</name>
    <message>
        <source>phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>Amplitudenreserve</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>Offener Kreis</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>vorgeschlagen</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Führungsgröße</translation>
    </message>
    <message>
        <source>Predicted step of 1 rad, linear loop</source>
        <translation>Vorhergesagter Sprung um 1 rad, linearer Kreis</translation>
    </message>
    <message>
        <source>friction band</source>
        <translation>Reibungsband</translation>
    </message>
    <message>
        <source>Predicted step with friction and current limit,</source>
        <translation>Vorhergesagter Sprung mit Reibung und Stromgrenze,</translation>
    </message>
    <message>
        <source>Verification move: measured over predicted</source>
        <translation>Nachweis: gemessen über vorhergesagt</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorhergesagt</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
</context>
<context>
    <name>halbench::app::WizardPanel</name>
    <message>
        <source>It could not start: no device, or it is busy.</source>
        <translation>Es konnte nicht starten: kein Gerät, oder es ist beschäftigt.</translation>
    </message>
    <message>
        <source>Connect a device, or wait for the end of what runs.</source>
        <translation>Verbinden Sie ein Gerät, oder warten Sie auf das Ende dessen, was läuft.</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::BandItem</name>
    <message>
        <source>limit</source>
        <translation>Grenzwert</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::CursorBar</name>
    <message>
        <source>Time of cursor %1</source>
        <translation>Zeit der Messmarke %1</translation>
    </message>
    <message>
        <source>Time of cursor %1: type it, drag the line, or press %1 and move it with the arrow keys</source>
        <translation>Zeit der Messmarke %1: schreiben Sie sie, ziehen Sie die Linie, oder drücken Sie %1 und bewegen sie mit den Pfeiltasten</translation>
    </message>
    <message>
        <source>Distance of the cursors</source>
        <translation>Abstand der Messmarken</translation>
    </message>
    <message>
        <source>Δt %1 s    1/Δt %2 Hz</source>
        <translation>Δt %1 s    1/Δt %2 Hz</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::EmptyState</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::EstimateTable</name>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>± (95 %)</source>
        <translation>± (95 %)</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>95 % interval: %1 to %2</source>
        <translation>95-%-Intervall: %1 bis %2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::FigureProbe</name>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>Against %1: %2</source>
        <translation>Über %1: %2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::FigureView</name>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Nothing to show yet</source>
        <translation>Noch nichts zu zeigen</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::Figures</name>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>Schätzwert</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LegendTableModel</name>
    <message>
        <source>, not updated any more</source>
        <translation>, wird nicht mehr aktualisiert</translation>
    </message>
    <message>
        <source>%1: %2 %3%4</source>
        <translation>%1: %2 %3%4</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LiveLegend</name>
    <message>
        <source>Legend with live values</source>
        <translation>Legende mit laufenden Werten</translation>
    </message>
    <message>
        <source>Space hides or shows the chosen curve, Delete removes it from the plot.</source>
        <translation>Die Leertaste blendet die gewählte Kurve aus oder ein, Entf entfernt sie aus dem Diagramm.</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LivePlot</name>
    <message>
        <source>Drag signals here or press Insert</source>
        <translation>Signale hierher ziehen oder Einfg drücken</translation>
    </message>
    <message>
        <source>Empty plot</source>
        <translation>Leeres Diagramm</translation>
    </message>
    <message>
        <source>Plot of %1</source>
        <translation>Diagramm: %1</translation>
    </message>
    <message>
        <source>Arrow keys move a cursor, plus and minus zoom, Space pauses, F fits, Insert adds signals.</source>
        <translation>Pfeiltasten bewegen eine Messmarke, Plus und Minus zoomen, die Leertaste hält an, F passt ein, Einfg fügt Signale hinzu.</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LivePlotStack</name>
    <message>
        <source>Live values of %1</source>
        <translation>Laufende Werte: %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Freeze the view; data are kept and go on being recorded</source>
        <translation>Die Ansicht einfrieren; Daten bleiben erhalten und werden weiter aufgezeichnet</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Keep the newest sample in view</source>
        <translation>Den neuesten Wert im Bild behalten</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Fit the value axes; when the view stands still, show all of the history</source>
        <translation>Die Wertachsen einpassen; steht die Ansicht, den ganzen Verlauf zeigen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Show all of the history</source>
        <translation>Den ganzen Verlauf zeigen</translation>
    </message>
    <message>
        <source>Zoom back</source>
        <translation>Zoom zurück</translation>
    </message>
    <message>
        <source>Return to the view before</source>
        <translation>Zurück zur vorigen Ansicht</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Show a shorter stretch of time</source>
        <translation>Eine kürzere Zeitspanne zeigen</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Show a longer stretch of time</source>
        <translation>Eine längere Zeitspanne zeigen</translation>
    </message>
    <message>
        <source>Scroll back</source>
        <translation>Zurückblättern</translation>
    </message>
    <message>
        <source>Show what was before</source>
        <translation>Zeigen, was vorher war</translation>
    </message>
    <message>
        <source>Scroll on</source>
        <translation>Weiterblättern</translation>
    </message>
    <message>
        <source>Show what came after</source>
        <translation>Zeigen, was danach kam</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Messmarken</translation>
    </message>
    <message>
        <source>Two cursors that measure; drag them or move them with the arrow keys</source>
        <translation>Zwei Marken, die messen; mit der Maus ziehen oder mit den Pfeiltasten bewegen</translation>
    </message>
    <message>
        <source>Cursor A</source>
        <translation>Messmarke A</translation>
    </message>
    <message>
        <source>Arrow keys move cursor A</source>
        <translation>Pfeiltasten bewegen Messmarke A</translation>
    </message>
    <message>
        <source>Cursor B</source>
        <translation>Messmarke B</translation>
    </message>
    <message>
        <source>Arrow keys move cursor B</source>
        <translation>Pfeiltasten bewegen Messmarke B</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>Diesen Augenblick markieren</translation>
    </message>
    <message>
        <source>Add signals</source>
        <translation>Signale hinzufügen</translation>
    </message>
    <message>
        <source>Choose signals to show</source>
        <translation>Signale wählen, die gezeigt werden</translation>
    </message>
    <message>
        <source>Paused, data are kept (%1 s since)</source>
        <translation>Angehalten, Daten bleiben erhalten (seit %1 s)</translation>
    </message>
    <message>
        <source>Following, %1 s</source>
        <translation>Folgt, %1 s</translation>
    </message>
    <message>
        <source>Scrolled; press End to follow</source>
        <translation>Verschoben; Ende drücken, um zu folgen</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LogTableModel</name>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>Einzelheit</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2-mal)</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LogView</name>
    <message>
        <source>Filter messages</source>
        <translation>Meldungen filtern</translation>
    </message>
    <message>
        <source>Show only messages whose source or text contains this</source>
        <translation>Nur Meldungen zeigen, deren Quelle oder Text dies enthält</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Notes and worse</source>
        <translation>Hinweise und Schwereres</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Warnungen und Fehler</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>The least important messages that are shown</source>
        <translation>Die unwichtigsten Meldungen, die gezeigt werden</translation>
    </message>
    <message>
        <source>Level of messages</source>
        <translation>Stufe der Meldungen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected messages, or all that are shown (%1)</source>
        <translation>Die gewählten Meldungen kopieren, oder alle gezeigten (%1)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Forget all messages</source>
        <translation>Alle Meldungen vergessen</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::MessageBar</name>
    <message>
        <source>Dismiss this message (Delete)</source>
        <translation>Diese Meldung schließen (Entf)</translation>
    </message>
    <message>
        <source>Dismiss message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::NumberLabel</name>
    <message>
        <source>No new value from the device: this is the last one it sent</source>
        <translation>Kein neuer Wert vom Gerät: das ist der letzte, den es gesendet hat</translation>
    </message>
    <message>
        <source>%1, old</source>
        <translation>%1, alt</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::OptionalNumberEdit</name>
    <message>
        <source>This is not a number</source>
        <translation>Das ist keine Zahl</translation>
    </message>
    <message>
        <source>At least %1</source>
        <translation>Mindestens %1</translation>
    </message>
    <message>
        <source>More than %1</source>
        <translation>Mehr als %1</translation>
    </message>
    <message>
        <source>At most %1</source>
        <translation>Höchstens %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ParameterTable</name>
    <message>
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>%1 to %2 %3, default %4</source>
        <translation>%1 bis %2 %3, Vorgabe %4</translation>
    </message>
    <message>
        <source>changes together with the other gains, in one control cycle</source>
        <translation>ändert sich mit den übrigen Reglerparametern in einem Regelzyklus</translation>
    </message>
    <message>
        <source>can only be read</source>
        <translation>kann nur gelesen werden</translation>
    </message>
    <message>
        <source>Select a parameter to read what it does.</source>
        <translation>Wählen Sie einen Parameter, um zu lesen, was er bewirkt.</translation>
    </message>
    <message>
        <source>Write changed (%1)</source>
        <translation>Änderungen schreiben (%1)</translation>
    </message>
    <message>
        <source>Write changed</source>
        <translation>Änderungen schreiben</translation>
    </message>
    <message>
        <source>Write the changed values to the device and read them back</source>
        <translation>Die geänderten Werte in das Gerät schreiben und zurücklesen</translation>
    </message>
    <message>
        <source>Connect a device to write to it</source>
        <translation>Verbinden Sie ein Gerät, um zu schreiben</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Read all values from the device</source>
        <translation>Alle Werte aus dem Gerät lesen</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Forget the edits: show what the device holds</source>
        <translation>Die Bearbeitung vergessen: zeigen, was das Gerät hat</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Edit every value to its default; nothing is written yet</source>
        <translation>Jeden Wert auf seine Vorgabe setzen; noch wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation>Die letzte Bearbeitung rückgängig machen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo the edit</source>
        <translation>Die Bearbeitung wiederholen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Parameter suchen</translation>
    </message>
    <message>
        <source>Search name, unit or help</source>
        <translation>Name, Einheit oder Hilfe suchen</translation>
    </message>
    <message>
        <source>Changed only</source>
        <translation>Nur Änderungen</translation>
    </message>
    <message>
        <source>Show only values edited here or changed outside</source>
        <translation>Nur Werte zeigen, die hier bearbeitet oder anderswo geändert wurden</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle unit of what is shown and typed here</source>
        <translation>Winkeleinheit dessen, was hier gezeigt und geschrieben wird</translation>
    </message>
    <message>
        <source>Angle unit</source>
        <translation>Winkeleinheit</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>F2 or typing edits the value</source>
        <translation>F2 oder Tippen bearbeitet den Wert</translation>
    </message>
    <message>
        <source>Help on the parameter</source>
        <translation>Hilfe zum Parameter</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ParameterTableModel</name>
    <message>
        <source>Changed outside this window: was %1, is now %2</source>
        <translation>Außerhalb dieses Fensters geändert: war %1, ist jetzt %2</translation>
    </message>
    <message>
        <source>The device is gone; this is the last value it reported</source>
        <translation>Das Gerät ist weg; das ist der letzte Wert, den es gemeldet hat</translation>
    </message>
    <message>
        <source>Edited, not on the device yet: the device holds %1</source>
        <translation>Bearbeitet, noch nicht im Gerät: das Gerät hat %1</translation>
    </message>
    <message>
        <source>This value can only be read</source>
        <translation>Dieser Wert kann nur gelesen werden</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Kleinstwert</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Größtwert</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Übrige</translation>
    </message>
    <message>
        <source>edit of %1</source>
        <translation>Bearbeitung von %1</translation>
    </message>
    <message>
        <source>Allowed is %1 to %2.</source>
        <translation>Erlaubt ist %1 bis %2.</translation>
    </message>
    <message>
        <source>%1 can only be read.</source>
        <translation>%1 kann nur gelesen werden.</translation>
    </message>
    <message>
        <source>%1: “%2” is not a number.</source>
        <translation>%1: „%2“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 needs a whole number, not %2.</source>
        <translation>%1 braucht eine ganze Zahl, nicht %2.</translation>
    </message>
    <message>
        <source>%1: %2 is outside its limits.</source>
        <translation>%1: %2 liegt außerhalb der Grenzen.</translation>
    </message>
    <message>
        <source>revert</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>Vorgaben</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ProgressRow</name>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel and put everything back as it was</source>
        <translation>Abbrechen und alles zurücksetzen, wie es war</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::QuantityEdit</name>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>Allowed: %1 (arrow keys: one step, Page Up and Page Down: ten)</source>
        <translation>Erlaubt: %1 (Pfeiltasten: ein Schritt, Bild auf und Bild ab: zehn)</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::RotorView</name>
    <message numerus="yes">
        <source>%n separate magnets</source>
        <translation>
            <numerusform>%n einzelner Magnet</numerusform>
            <numerusform>%n einzelne Magnete</numerusform>
        </translation>
    </message>
    <message>
        <source>as the Hall sensors see it</source>
        <translation>wie die Hall-Sensoren es sehen</translation>
    </message>
    <message>
        <source>ideal cylinder</source>
        <translation>idealer Zylinder</translation>
    </message>
    <message>
        <source>Cross-section of the rotor</source>
        <translation>Querschnitt des Rotors</translation>
    </message>
    <message>
        <source>rotor at %1 degrees</source>
        <translation>Rotor bei %1 Grad</translation>
    </message>
    <message>
        <source>angle not known</source>
        <translation>Winkel nicht bekannt</translation>
    </message>
    <message>
        <source>%1 (old); field: %2</source>
        <translation>%1 (alt); Feld: %2</translation>
    </message>
    <message>
        <source>%1; field: %2</source>
        <translation>%1; Feld: %2</translation>
    </message>
    <message>
        <source>a</source>
        <translation>a</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>ψ %1</source>
        <translation>ψ %1</translation>
    </message>
    <message>
        <source>Phase A
%1
Phase B
%2</source>
        <translation>Phase A
%1
Phase B
%2</translation>
    </message>
    <message>
        <source>Hall a
%1
Hall b
%2</source>
        <translation>Hall a
%1
Hall b
%2</translation>
    </message>
    <message>
        <source>old values</source>
        <translation>alte Werte</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StatusStrip</name>
    <message>
        <source>Connected</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Running %1</source>
        <translation>%1 läuft</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Stopped (%1)</source>
        <translation>Gestoppt (%1)</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Fault (%1)</source>
        <translation>Fehler (%1)</translation>
    </message>
    <message>
        <source>Disconnected</source>
        <translation>Getrennt</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Kein Gerät</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>This device is a simulation inside the program; nothing real moves</source>
        <translation>Dieses Gerät ist eine Simulation im Programm; nichts Wirkliches bewegt sich</translation>
    </message>
    <message>
        <source>State of the device</source>
        <translation>Zustand des Geräts</translation>
    </message>
    <message>
        <source>%1, simulated, %2</source>
        <translation>%1, simuliert, %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Zeichnet auf: %1</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>Keine Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StepList</name>
    <message>
        <source>current</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>done with a warning</source>
        <translation>fertig mit Warnung</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>gescheitert</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>übersprungen</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>Step %1 of %2, %3, %4</source>
        <translation>Schritt %1 von %2, %3, %4</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StopButton</name>
    <message>
        <source>STOPPED — re-arm</source>
        <translation>GESTOPPT — aufheben</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>GESTOPPT</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Software stop: current to zero at once, latched until re-armed (Esc)</source>
        <translation>Software-Stopp: sofort Strom null, verriegelt bis zum Aufheben (Esc)</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Gestoppt.</translation>
    </message>
    <message>
        <source>Stopped: %1.</source>
        <translation>Gestoppt: %1.</translation>
    </message>
    <message>
        <source>%1 Re-arming is locked for a few seconds; Esc still stops.</source>
        <translation>%1 Das Aufheben ist für einige Sekunden gesperrt; Esc stoppt weiterhin.</translation>
    </message>
    <message>
        <source>%1 Click to re-arm; set-points start at zero. Esc still stops.</source>
        <translation>%1 Klicken hebt den Stopp auf; Sollwerte beginnen bei null. Esc stoppt weiterhin.</translation>
    </message>
    <message>
        <source>Stopped, re-arm</source>
        <translation>Gestoppt, aufheben</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::TimeAxisBar</name>
    <message>
        <source>Time axis</source>
        <translation>Zeitachse</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::VerdictView</name>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
</context>
</TS>
