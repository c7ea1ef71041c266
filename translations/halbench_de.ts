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
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>Konfiguration</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>XY</source>
        <translation>XY</translation>
    </message>
    <message>
        <source>Derived signals</source>
        <translation>Abgeleitete Signale</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>Relay experiment</source>
        <translation>Relaisversuch</translation>
    </message>
    <message>
        <source>Monitor 2</source>
        <translation>Monitor 2</translation>
    </message>
    <message>
        <source>Monitor 3</source>
        <translation>Monitor 3</translation>
    </message>
</context>
<context>
    <name>Phrases</name>
    <message>
        <source>{}; move one after the other</source>
        <translation>{}; eine nach der anderen bewegen</translation>
    </message>
    <message>
        <source>{}; name one with --axis, in an experiment with the key &apos;axis&apos;</source>
        <translation>{}; eine mit --axis nennen, in einem Experiment mit dem Schlüssel 'axis'</translation>
    </message>
    <message>
        <source>its axes are {}</source>
        <translation>seine Achsen sind {}</translation>
    </message>
    <message>
        <source>use one of its own: {}</source>
        <translation>eines der eigenen verwenden: {}</translation>
    </message>
    <message>
        <source>the procedure {} does not suit this device; nothing was armed</source>
        <translation>das Verfahren {} passt nicht zu diesem Gerät; nichts wurde freigegeben</translation>
    </message>
    <message>
        <source>choose a1 and a2 with 0 &lt; a2 &lt; a1 and 4 - 2 a1 + a2 &gt; 0</source>
        <translation>a1 und a2 mit 0 &lt; a2 &lt; a1 und 4 - 2 a1 + a2 &gt; 0 wählen</translation>
    </message>
    <message>
        <source>correct the coefficients of the section</source>
        <translation>die Koeffizienten des Glieds berichtigen</translation>
    </message>
    <message>
        <source>leave some of them out</source>
        <translation>einige davon weglassen</translation>
    </message>
    <message>
        <source>The time in row {} of the table of poses does not rise.</source>
        <translation>Die Zeit in Zeile {} der Tabelle der Lagen steigt nicht.</translation>
    </message>
    <message>
        <source>Row {} of the table of poses is not finite.</source>
        <translation>Zeile {} der Tabelle der Lagen ist nicht endlich.</translation>
    </message>
    <message>
        <source>coil field {} of sensor {}</source>
        <translation>Spulenfeld {} von Sensor {}</translation>
    </message>
    <message>
        <source>place along {} of sensor {}</source>
        <translation>Platz längs {} von Sensor {}</translation>
    </message>
    <message>
        <source>frame about {} of sensor {}</source>
        <translation>Verdrehung um {} von Sensor {}</translation>
    </message>
    <message>
        <source>offset {} of sensor {}</source>
        <translation>Nullpunktfehler {} von Sensor {}</translation>
    </message>
    <message>
        <source>skew {} of sensor {}</source>
        <translation>Schiefe {} von Sensor {}</translation>
    </message>
    <message>
        <source>gain {} of sensor {}</source>
        <translation>Verstärkung {} von Sensor {}</translation>
    </message>
    <message>
        <source>field strength {}</source>
        <translation>Feldstärke {}</translation>
    </message>
    <message>
        <source>The motion does not determine this value: {}.</source>
        <translation>Die Bewegung bestimmt diesen Wert nicht: {}.</translation>
    </message>
    <message>
        <source>Widen the region, reduce the distance or raise the range of the sensor.</source>
        <translation>Den Bereich erweitern, den Abstand verkleinern oder den Messbereich des Sensors erhöhen.</translation>
    </message>
    <message>
        <source>The constraints leave no pair of places for the sensors.</source>
        <translation>Die Nebenbedingungen lassen kein Paar von Orten für die Sensoren übrig.</translation>
    </message>
    <message>
        <source>A placement needs sensors outside the rotor, a positive strength and noise, and at least one finalist.</source>
        <translation>Eine Anordnung braucht Sensoren außerhalb des Läufers, positive Stärke und positives Rauschen und mindestens einen Endrundenplatz.</translation>
    </message>
    <message>
        <source>Use the objective reading, or the exact device.</source>
        <translation>Das Ziel reading oder das exakte Modell verwenden.</translation>
    </message>
    <message>
        <source>The additive device has no tensor to condition.</source>
        <translation>Das additive Modell hat keinen Tensor, dessen Kondition zu bestimmen wäre.</translation>
    </message>
    <message>
        <source>The step of the placement lattice must divide 45 degrees and be at least 1 degree.</source>
        <translation>Die Schrittweite des Rasters der Anordnungen muss 45 Grad teilen und mindestens 1 Grad sein.</translation>
    </message>
    <message>
        <source>harmonic ({},{})</source>
        <translation>Kugelflächenfunktion ({},{})</translation>
    </message>
    <message>
        <source>drift of {} with temperature</source>
        <translation>Drift von {} mit der Temperatur</translation>
    </message>
    <message>
        <source>A common rotation of all sensors cannot be told from one of the rotor: the mean turn is zero. Only a known orientation fixes it.</source>
        <translation>Eine gemeinsame Drehung aller Sensoren ist von einer des Läufers nicht zu trennen: Die mittlere Drehung ist null. Nur eine bekannte Lage legt sie fest.</translation>
    </message>
    <message>
        <source>The common scale of all gains cannot be told from the strength q: their mean is one. Only a known field fixes it; it does not change the orientation.</source>
        <translation>Der gemeinsame Faktor aller Verstärkungen ist von der Stärke q nicht zu trennen: Ihr Mittel ist eins. Nur ein bekanntes Feld legt ihn fest; die Lage ändert er nicht.</translation>
    </message>
    <message>
        <source>Record orientations that differ more in tilt and spin, or keep it at its nominal value.</source>
        <translation>Lagen aufzeichnen, die sich in Neigung und Drehung stärker unterscheiden, oder den Nennwert behalten.</translation>
    </message>
    <message>
        <source>The calibration was stopped.</source>
        <translation>Die Kalibrierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Turn it through the whole workspace, tilt and spin.</source>
        <translation>Ihn durch den ganzen Arbeitsbereich bewegen: neigen und drehen.</translation>
    </message>
    <message>
        <source>The rotor moved by only {} degrees in the recording.</source>
        <translation>Der Läufer bewegte sich in der Aufzeichnung nur um {} Grad.</translation>
    </message>
    <message>
        <source>Nothing is selected to be calibrated.</source>
        <translation>Zum Kalibrieren ist nichts ausgewählt.</translation>
    </message>
    <message>
        <source>A calibration needs positive deviations of readings and known orientations and at least one iteration.</source>
        <translation>Eine Kalibrierung braucht positive Abweichungen der Messwerte und der bekannten Lagen und mindestens einen Schritt.</translation>
    </message>
    <message>
        <source>Record longer, with the rotor moving and no channel clipped.</source>
        <translation>Länger aufzeichnen, mit bewegtem Läufer und ohne übersteuerten Kanal.</translation>
    </message>
    <message>
        <source>Only {} samples have a known orientation; the calibration needs {}.</source>
        <translation>Nur {} Abtastwerte haben eine bekannte Lage; die Kalibrierung braucht {}.</translation>
    </message>
    <message>
        <source>m, rad, N or N*m; height of a step of the staircase, end of the ramp, distance</source>
        <translation>m, rad, N oder N*m; Höhe einer Stufe der Treppe, Ende der Rampe, Weg</translation>
    </message>
    <message>
        <source>Slope of the ramp, speed of the trapezoid, per second</source>
        <translation>Steigung der Rampe, Geschwindigkeit des Trapezes, je Sekunde</translation>
    </message>
    <message>
        <source>Largest acceleration of the trapezoid per second squared</source>
        <translation>Größte Beschleunigung des Trapezes je Sekunde im Quadrat</translation>
    </message>
    <message>
        <source>trapezoid</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>Pose and speed from the readings</source>
        <translation>Pose und Geschwindigkeit aus den Messwerten</translation>
    </message>
    <message>
        <source>Squared innovation of the tracking filter, 6 when all is well</source>
        <translation>Quadrierte Innovation des Folgefilters, im Normalfall 6</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>kleinste Quadrate</translation>
    </message>
    <message>
        <source>tracking filter</source>
        <translation>Folgefilter</translation>
    </message>
    <message>
        <source>From the wrench to the currents</source>
        <translation>Von Kraft und Moment zu den Strömen</translation>
    </message>
    <message>
        <source>set by set</source>
        <translation>Spulenpaar für Spulenpaar</translation>
    </message>
    <message>
        <source>heading, fundamental</source>
        <translation>mit Drehlage, Grundwelle</translation>
    </message>
    <message>
        <source>heading, all harmonics</source>
        <translation>mit Drehlage, alle Oberwellen</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>chip</source>
        <translation>Hallchip</translation>
    </message>
    <message>
        <source>coil</source>
        <translation>Spule</translation>
    </message>
    <message>
        <source>platen</source>
        <translation>Läufer</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Pose of the platen along {}</source>
        <translation>Pose des Läufers entlang {}</translation>
    </message>
    <message>
        <source>Pose of the platen about the vertical</source>
        <translation>Drehlage des Läufers um die Hochachse</translation>
    </message>
    <message>
        <source>Speed of the platen along {}</source>
        <translation>Geschwindigkeit des Läufers entlang {}</translation>
    </message>
    <message>
        <source>Speed of the platen about the vertical</source>
        <translation>Drehgeschwindigkeit des Läufers um die Hochachse</translation>
    </message>
    <message>
        <source>Reference, or effort in mode wrench, along {}</source>
        <translation>Führungsgröße, in der Betriebsart Kraft und Moment die Kraft, entlang {}</translation>
    </message>
    <message>
        <source>Reference, or effort in mode wrench, about the vertical</source>
        <translation>Führungsgröße, in der Betriebsart Kraft und Moment das Moment, um die Hochachse</translation>
    </message>
    <message>
        <source>Force or torque of the currents along {}</source>
        <translation>Kraft der Ströme entlang {}</translation>
    </message>
    <message>
        <source>Force or torque of the currents about the vertical</source>
        <translation>Moment der Ströme um die Hochachse</translation>
    </message>
    <message>
        <source>Current commanded into coil {}</source>
        <translation>Vorgegebener Strom in Spule {}</translation>
    </message>
    <message>
        <source>Field along x&apos; at chip {}</source>
        <translation>Feld entlang x&apos; am Hallchip {}</translation>
    </message>
    <message>
        <source>Field along y&apos; at chip {}</source>
        <translation>Feld entlang y&apos; am Hallchip {}</translation>
    </message>
    <message>
        <source>Vertical force of the coils, upward</source>
        <translation>Senkrechte Kraft der Spulen, nach oben positiv</translation>
    </message>
    <message>
        <source>Squared residuals of the readings over their deviation</source>
        <translation>Quadrierte Abweichungen der Messwerte, bezogen auf ihre Streuung</translation>
    </message>
    <message>
        <source>Below 1: currents at their limit</source>
        <translation>Unter 1: Ströme an ihrer Grenze</translation>
    </message>
    <message>
        <source>Pitches from the first cell along {}</source>
        <translation>Teilungen seit der ersten Zelle entlang {}</translation>
    </message>
    <message>
        <source>1, 2, 4: chips that are not used, added</source>
        <translation>1, 2, 4: nicht verwendete Hallchips, addiert</translation>
    </message>
    <message>
        <source>The first cell was chosen</source>
        <translation>Die erste Zelle wurde gewählt</translation>
    </message>
    <message>
        <source>coil currents</source>
        <translation>Spulenströme</translation>
    </message>
    <message>
        <source>wrench</source>
        <translation>Kraft und Moment</translation>
    </message>
    <message>
        <source>pose jumped</source>
        <translation>Pose gesprungen</translation>
    </message>
    <message>
        <source>sensors determine no pose</source>
        <translation>die Sensoren bestimmen keine Pose</translation>
    </message>
    <message>
        <source>vertical force near the weight</source>
        <translation>senkrechte Kraft nahe dem Gewicht</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>Derivative gain on the measured speed</source>
        <translation>Differentialverstärkung auf die gemessene Geschwindigkeit</translation>
    </message>
    <message>
        <source>Part of a step that the proportional gain sees</source>
        <translation>Anteil eines Sprungs, der auf die Proportionalverstärkung wirkt</translation>
    </message>
    <message>
        <source>Effort per acceleration of a profile</source>
        <translation>Kraft oder Moment je Beschleunigung eines Profils</translation>
    </message>
    <message>
        <source>Moving mass</source>
        <translation>Bewegte Masse</translation>
    </message>
    <message>
        <source>Inertia about the vertical</source>
        <translation>Trägheitsmoment um die Hochachse</translation>
    </message>
    <message>
        <source>Centre of mass in platen axes</source>
        <translation>Schwerpunkt in Achsen des Läufers</translation>
    </message>
    <message>
        <source>Force per ampere; negative by the sign of the phases</source>
        <translation>Kraft je Ampere; negativ durch das Vorzeichen der Phasen</translation>
    </message>
    <message>
        <source>Pitch of the magnet matrix</source>
        <translation>Teilung der Magnetmatrix</translation>
    </message>
    <message>
        <source>Width of a coil&apos;s winding</source>
        <translation>Breite der Wicklung einer Spule</translation>
    </message>
    <message>
        <source>Place of coils 5 and 6 along y&apos;</source>
        <translation>Lage der Spulen 5 und 6 entlang y&apos;</translation>
    </message>
    <message>
        <source>Time constant of the speeds</source>
        <translation>Zeitkonstante der Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Largest current of a coil</source>
        <translation>Größter Strom einer Spule</translation>
    </message>
    <message>
        <source>Vertical force that trips</source>
        <translation>Senkrechte Kraft, die abschaltet</translation>
    </message>
    <message>
        <source>Largest excursion from where the mode began</source>
        <translation>Größte Auslenkung seit Beginn der Betriebsart</translation>
    </message>
    <message>
        <source>Largest rotation from where the mode began</source>
        <translation>Größte Drehung seit Beginn der Betriebsart</translation>
    </message>
    <message>
        <source>Largest speed of rotation while armed</source>
        <translation>Größte Drehgeschwindigkeit im scharfen Zustand</translation>
    </message>
    <message>
        <source>Delay of the currents</source>
        <translation>Verzögerung der Ströme</translation>
    </message>
    <message>
        <source>Field amplitude at the chip</source>
        <translation>Feldamplitude am Hallchip</translation>
    </message>
    <message>
        <source>Place of the chip in platen axes</source>
        <translation>Lage des Hallchips in Achsen des Läufers</translation>
    </message>
    <message>
        <source>Error of the sensitivity along x&apos;</source>
        <translation>Fehler der Empfindlichkeit entlang x&apos;</translation>
    </message>
    <message>
        <source>Error of the sensitivity along y&apos;</source>
        <translation>Fehler der Empfindlichkeit entlang y&apos;</translation>
    </message>
    <message>
        <source>Share of the field along y&apos; in the reading of x&apos;</source>
        <translation>Anteil des Feldes entlang y&apos; am Messwert von x&apos;</translation>
    </message>
    <message>
        <source>Share of the field along x&apos; in the reading of y&apos;</source>
        <translation>Anteil des Feldes entlang x&apos; am Messwert von y&apos;</translation>
    </message>
    <message>
        <source>Offset of the reading of x&apos;</source>
        <translation>Nullpunktfehler des Messwerts von x&apos;</translation>
    </message>
    <message>
        <source>Offset of the reading of y&apos;</source>
        <translation>Nullpunktfehler des Messwerts von y&apos;</translation>
    </message>
    <message>
        <source>Field of coil 1 ... 6 at chip 1 along x&apos;, along y&apos;, at chip 2, ...</source>
        <translation>Feld der Spulen 1 ... 6 am Hallchip 1 entlang x&apos;, entlang y&apos;, am Hallchip 2, ...</translation>
    </message>
    <message>
        <source>Deviation of a reading: noise and what calibration leaves</source>
        <translation>Streuung eines Messwerts: Rauschen und Rest der Kalibrierung</translation>
    </message>
    <message>
        <source>m from where the mode began, or N</source>
        <translation>m seit Beginn der Betriebsart, oder N</translation>
    </message>
    <message>
        <source>rad from where the mode began, or N*m</source>
        <translation>rad seit Beginn der Betriebsart, oder N*m</translation>
    </message>
    <message>
        <source>Current of one coil in mode coil currents</source>
        <translation>Strom einer Spule in der Betriebsart Spulenströme</translation>
    </message>
    <message>
        <source>1 counts cells from the present one</source>
        <translation>1 zählt die Zellen ab der jetzigen</translation>
    </message>
    <message>
        <source>Constant speed added in mode position, else effort</source>
        <translation>Zusätzliche konstante Geschwindigkeit in der Betriebsart Position, sonst Kraft oder Moment</translation>
    </message>
    <message>
        <source>force constant</source>
        <translation>Kraftkonstante</translation>
    </message>
    <message>
        <source>Planar six-coil positioner</source>
        <translation>Planarer Positionierer mit sechs Spulen</translation>
    </message>
    <message>
        <source>True pose along x, known to the simulation only</source>
        <translation>Wahre Pose entlang x, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True pose along y, known to the simulation only</source>
        <translation>Wahre Pose entlang y, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True rotation, known to the simulation only</source>
        <translation>Wahre Drehlage, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True speed along x, known to the simulation only</source>
        <translation>Wahre Geschwindigkeit entlang x, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True speed along y, known to the simulation only</source>
        <translation>Wahre Geschwindigkeit entlang y, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True speed of rotation, known to the simulation only</source>
        <translation>Wahre Drehgeschwindigkeit, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True force of the coils along x, known to the simulation only</source>
        <translation>Wahre Kraft der Spulen entlang x, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True force of the coils along y, known to the simulation only</source>
        <translation>Wahre Kraft der Spulen entlang y, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True torque of the coils, known to the simulation only</source>
        <translation>Wahres Moment der Spulen, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>check the link</source>
        <translation>die Verbindung prüfen</translation>
    </message>
    <message>
        <source>deg is an angle: degrees Celsius are written degC</source>
        <translation>deg ist ein Winkel: Grad Celsius schreibt man degC</translation>
    </message>
    <message>
        <source>name the column after what it is, e.g. {}; halbench import --unit says the unit</source>
        <translation>benennen Sie die Spalte nach dem, was sie ist, z. B. {}; halbench import --unit nennt die Einheit</translation>
    </message>
    <message>
        <source>{}:1: column &apos;{}&apos; is in &apos;{}&apos;, but {} is in {}</source>
        <translation>{}:1: Spalte „{}“ steht in „{}“, aber {} in {}</translation>
    </message>
    <message>
        <source>{}: signals[{}].unit: &apos;{}&apos; contradicts the column &apos;{}&apos;</source>
        <translation>{}: signals[{}].unit: „{}“ widerspricht der Spalte „{}“</translation>
    </message>
    <message>
        <source>correct the unit, or remove the sidecar to read the data without it</source>
        <translation>berichtigen Sie die Einheit, oder entfernen Sie die Begleitdatei, um die Daten ohne sie zu lesen</translation>
    </message>
    <message>
        <source>unit of column &apos;{}&apos; in &apos;{}&apos;: deg is an angle; degrees Celsius are written degC</source>
        <translation>Einheit der Spalte „{}“ in „{}“: deg ist ein Winkel; Grad Celsius schreibt man degC</translation>
    </message>
    <message>
        <source>unit of column &apos;{}&apos; in &apos;{}&apos;: none is written, {} is assumed</source>
        <translation>Einheit der Spalte „{}“ in „{}“: keine angegeben, {} wird angenommen</translation>
    </message>
    <message>
        <source>is {}, but the parameters say {}/{} = {}</source>
        <translation>ist {}, aber die Parameter sagen {}/{} = {}</translation>
    </message>
    <message>
        <source>the values of a model belong together: identify again with --given, e.g. &apos;halbench identify FILE.csv --given J=5.5e-4 --out&apos;</source>
        <translation>die Werte eines Modells gehören zusammen: identifizieren Sie neu mit --given, z. B. „halbench identify FILE.csv --given J=5.5e-4 --out“</translation>
    </message>
    <message>
        <source>{}: &quot;parameters[{}]</source>
        <translation>{}: &quot;parameters[{}]</translation>
    </message>
    <message>
        <source>{} of the recording is in {}, not in {}</source>
        <translation>{} der Aufzeichnung steht in {}, nicht in {}</translation>
    </message>
    <message>
        <source>a motor is identified from its angle and its current</source>
        <translation>ein Motor wird aus seinem Winkel und seinem Strom identifiziert</translation>
    </message>
    <message>
        <source>Rotor angle, unwrapped</source>
        <translation>Rotorwinkel, über Umdrehungen fortgezählt</translation>
    </message>
    <message>
        <source>Rotor speed, slope over 32 ms</source>
        <translation>Rotordrehzahl, Steigung über 32 ms</translation>
    </message>
    <message>
        <source>Reference: rad in mode position, else A</source>
        <translation>Führungsgröße: rad in der Betriebsart Lage, sonst A</translation>
    </message>
    <message>
        <source>Current amplitude commanded</source>
        <translation>Vorgegebene Stromamplitude</translation>
    </message>
    <message>
        <source>Current commanded into phase {}</source>
        <translation>Vorgegebener Strom in Phase {}</translation>
    </message>
    <message>
        <source>Field at Hall sensor {}, not corrected</source>
        <translation>Feld am Hall-Sensor {}, nicht korrigiert</translation>
    </message>
    <message>
        <source>Coil {}</source>
        <translation>Spule {}</translation>
    </message>
    <message>
        <source>State of the board</source>
        <translation>Zustand des Steuergeräts</translation>
    </message>
    <message>
        <source>Latched fault</source>
        <translation>Verriegelter Fehler</translation>
    </message>
    <message>
        <source>Control cycles that saw a mixed parameter set</source>
        <translation>Regelzyklen mit gemischtem Parametersatz</translation>
    </message>
    <message>
        <source>Step or plateau, 0 = not running</source>
        <translation>Stufe oder Plateau, 0 = läuft nicht</translation>
    </message>
    <message>
        <source>1 while the generator runs</source>
        <translation>1, solange der Generator läuft</translation>
    </message>
    <message>
        <source>State of the capture</source>
        <translation>Zustand der Erfassung</translation>
    </message>
    <message>
        <source>Device time of the trigger sample</source>
        <translation>Gerätezeit des Trigger-Abtastwerts</translation>
    </message>
    <message>
        <source>Proportional gain</source>
        <translation>Proportionalverstärkung</translation>
    </message>
    <message>
        <source>Integral gain</source>
        <translation>Integralverstärkung</translation>
    </message>
    <message>
        <source>Derivative gain on the measured angle</source>
        <translation>Differentialverstärkung auf den gemessenen Winkel</translation>
    </message>
    <message>
        <source>Set-point weight b of the proportional part</source>
        <translation>Sollwertgewicht b des P-Anteils</translation>
    </message>
    <message>
        <source>Set-point weight c of the derivative part</source>
        <translation>Sollwertgewicht c des D-Anteils</translation>
    </message>
    <message>
        <source>Time constant of the derivative&apos;s filter</source>
        <translation>Zeitkonstante des Filters am D-Anteil</translation>
    </message>
    <message>
        <source>Filter section (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2), d = z - 1</source>
        <translation>Filterglied (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2), d = z - 1</translation>
    </message>
    <message>
        <source>Coefficient b1 of the filter section</source>
        <translation>Koeffizient b1 des Filterglieds</translation>
    </message>
    <message>
        <source>Coefficient b2 of the filter section</source>
        <translation>Koeffizient b2 des Filterglieds</translation>
    </message>
    <message>
        <source>Coefficient a1 of the filter section; 0 switches it off</source>
        <translation>Koeffizient a1 des Filterglieds; 0 schaltet es aus</translation>
    </message>
    <message>
        <source>Coefficient a2 of the filter section</source>
        <translation>Koeffizient a2 des Filterglieds</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>0.9 K_f/phi, with the reference speed</source>
        <translation>0,9 K_f/phi, mit der Führungsdrehzahl</translation>
    </message>
    <message>
        <source>Reference speed of full Coulomb feed-forward</source>
        <translation>Führungsdrehzahl mit voller Coulomb-Vorsteuerung</translation>
    </message>
    <message>
        <source>Friction help at rest, 0.9 K_f/phi</source>
        <translation>Reibungshilfe im Stillstand, 0,9 K_f/phi</translation>
    </message>
    <message>
        <source>Error above which the friction help acts (0.16 degrees)</source>
        <translation>Fehler, über dem die Reibungshilfe wirkt (0,16 Grad)</translation>
    </message>
    <message>
        <source>Reference speed below which the friction help acts</source>
        <translation>Führungsdrehzahl, unter der die Reibungshilfe wirkt</translation>
    </message>
    <message>
        <source>Form of the control law</source>
        <translation>Form des Regelgesetzes</translation>
    </message>
    <message>
        <source>Largest current amplitude</source>
        <translation>Größte Stromamplitude</translation>
    </message>
    <message>
        <source>Coil temperature that trips</source>
        <translation>Spulentemperatur, die abschaltet</translation>
    </message>
    <message>
        <source>Largest excursion from the position at arming</source>
        <translation>Größte Auslenkung von der Lage bei der Freigabe</translation>
    </message>
    <message>
        <source>Position window</source>
        <translation>Lagefenster</translation>
    </message>
    <message>
        <source>Largest speed while armed</source>
        <translation>Größte Drehzahl, solange freigegeben</translation>
    </message>
    <message>
        <source>Speed window</source>
        <translation>Drehzahlfenster</translation>
    </message>
    <message>
        <source>Subtract the field of the phase currents</source>
        <translation>Das Feld der Phasenströme abziehen</translation>
    </message>
    <message>
        <source>Field of a phase current at its own sensor</source>
        <translation>Feld eines Phasenstroms am eigenen Sensor</translation>
    </message>
    <message>
        <source>Angle from the two fields</source>
        <translation>Winkel aus den beiden Feldern</translation>
    </message>
    <message>
        <source>Delay of the position loop in its samples</source>
        <translation>Totzeit des Lageregelkreises in Abtastwerten</translation>
    </message>
    <message>
        <source>Commutate every n-th millisecond</source>
        <translation>Jede n-te Millisekunde kommutieren</translation>
    </message>
    <message>
        <source>Commutation angle ahead by speed times this</source>
        <translation>Kommutierungswinkel voreilend um Drehzahl mal diesen Wert</translation>
    </message>
    <message>
        <source>Offset of channel {}</source>
        <translation>Offset von Kanal {}</translation>
    </message>
    <message>
        <source>Amplitude of channel B over channel A</source>
        <translation>Amplitude von Kanal B durch die von Kanal A</translation>
    </message>
    <message>
        <source>Channel B sees sin(angle + quadrature)</source>
        <translation>Kanal B sieht sin(Winkel + Quadraturfehler)</translation>
    </message>
    <message>
        <source>Field amplitude at the sensors</source>
        <translation>Feldamplitude an den Sensoren</translation>
    </message>
    <message>
        <source>Angle error map</source>
        <translation>Winkelfehlerkarte</translation>
    </message>
    <message>
        <source>Angle error map, cosine of order {}</source>
        <translation>Winkelfehlerkarte, Kosinus der Ordnung {}</translation>
    </message>
    <message>
        <source>Angle error map, sine of order {}</source>
        <translation>Winkelfehlerkarte, Sinus der Ordnung {}</translation>
    </message>
    <message>
        <source>Arm the outputs</source>
        <translation>Die Ausgänge freigeben</translation>
    </message>
    <message>
        <source>What the set-point means</source>
        <translation>Was der Sollwert bedeutet</translation>
    </message>
    <message>
        <source>A, or rad from the position at arming</source>
        <translation>A, oder rad ab der Lage bei der Freigabe</translation>
    </message>
    <message>
        <source>Silence of the host that stops the board</source>
        <translation>Schweigen des Rechners, das das Steuergerät stoppt</translation>
    </message>
    <message>
        <source>Write 1 to stop and latch</source>
        <translation>1 schreiben stoppt und verriegelt</translation>
    </message>
    <message>
        <source>A lost master brings this calibration back</source>
        <translation>Geht der Rechner verloren, kommt dieser Parametersatz zurück</translation>
    </message>
    <message>
        <source>Shape of the reference</source>
        <translation>Form des Verlaufs</translation>
    </message>
    <message>
        <source>rad or A; height of one step of the staircase, end of the ramp</source>
        <translation>rad oder A; Höhe einer Treppenstufe, Ende der Rampe</translation>
    </message>
    <message>
        <source>Slope of the ramp, rad/s or A/s</source>
        <translation>Steigung der Rampe, rad/s oder A/s</translation>
    </message>
    <message>
        <source>Frequency of sine; first of chirp and multisine</source>
        <translation>Frequenz des Sinus; erste von Chirp und Multisinus</translation>
    </message>
    <message>
        <source>Last frequency of chirp and multisine</source>
        <translation>Letzte Frequenz von Chirp und Multisinus</translation>
    </message>
    <message>
        <source>Time of one step of the staircase</source>
        <translation>Zeit einer Treppenstufe</translation>
    </message>
    <message>
        <source>Steps of the staircase, lines of the multisine</source>
        <translation>Stufen der Treppe, Linien des Multisinus</translation>
    </message>
    <message>
        <source>Time until the generator ends</source>
        <translation>Zeit bis zum Ende des Generators</translation>
    </message>
    <message>
        <source>Constant motion added: rad/s in mode position, else A</source>
        <translation>Zugefügte gleichförmige Bewegung: rad/s in der Betriebsart Lage, sonst A</translation>
    </message>
    <message>
        <source>Phases of the multisine; 0 = Schroeder</source>
        <translation>Phasen des Multisinus; 0 = Schroeder</translation>
    </message>
    <message>
        <source>Number of plateaus</source>
        <translation>Zahl der Plateaus</translation>
    </message>
    <message>
        <source>Time of one plateau</source>
        <translation>Zeit eines Plateaus</translation>
    </message>
    <message>
        <source>Signal of channel {} as handle (address/8), 255 = none</source>
        <translation>Signal von Kanal {} als Nummer (Adresse/8), 255 = keines</translation>
    </message>
    <message>
        <source>What starts the capture</source>
        <translation>Was die Erfassung startet</translation>
    </message>
    <message>
        <source>Handle of the signal compared with the level</source>
        <translation>Nummer des Signals, das mit dem Pegel verglichen wird</translation>
    </message>
    <message>
        <source>Level of the trigger</source>
        <translation>Pegel des Triggers</translation>
    </message>
    <message>
        <source>Direction of the crossing</source>
        <translation>Richtung des Durchgangs</translation>
    </message>
    <message>
        <source>Samples before the trigger</source>
        <translation>Abtastwerte vor dem Trigger</translation>
    </message>
    <message>
        <source>Milliseconds per sample</source>
        <translation>Millisekunden je Abtastwert</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>feedforward</source>
        <translation>Vorsteuerung</translation>
    </message>
    <message>
        <source>stiction</source>
        <translation>Reibungshilfe</translation>
    </message>
    <message>
        <source>control</source>
        <translation>Regelung</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenzwerte</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>stray</source>
        <translation>Streufeld</translation>
    </message>
    <message>
        <source>decode</source>
        <translation>Winkelberechnung</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>Totzeit</translation>
    </message>
    <message>
        <source>commutation</source>
        <translation>Kommutierung</translation>
    </message>
    <message>
        <source>hall</source>
        <translation>Hall-Sensoren</translation>
    </message>
    <message>
        <source>errormap</source>
        <translation>Winkelfehlerkarte</translation>
    </message>
    <message>
        <source>hb</source>
        <translation>Steuergerät</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Sollwertgenerator</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>Plateaus</translation>
    </message>
    <message>
        <source>capture</source>
        <translation>Erfassung</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>freigeben</translation>
    </message>
    <message>
        <source>disarm</source>
        <translation>sperren</translation>
    </message>
    <message>
        <source>stopped by command</source>
        <translation>durch Befehl gestoppt</translation>
    </message>
    <message>
        <source>stopped by watchdog</source>
        <translation>durch Überwachungszeit gestoppt</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>coil temperature above its limit</source>
        <translation>Spulentemperatur über ihrem Grenzwert</translation>
    </message>
    <message>
        <source>current above its limit</source>
        <translation>Strom über seinem Grenzwert</translation>
    </message>
    <message>
        <source>speed above its window</source>
        <translation>Drehzahl über ihrem Fenster</translation>
    </message>
    <message>
        <source>position left its window</source>
        <translation>Lage außerhalb ihres Fensters</translation>
    </message>
    <message>
        <source>angle jumped (ambiguous decode)</source>
        <translation>Winkel sprang (Dekodierung mehrdeutig)</translation>
    </message>
    <message>
        <source>sensor out of range</source>
        <translation>Sensor außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>value not finite</source>
        <translation>Wert nicht endlich</translation>
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
        <source>positional</source>
        <translation>Stellungsform</translation>
    </message>
    <message>
        <source>literal difference equation</source>
        <translation>Differenzengleichung wörtlich</translation>
    </message>
    <message>
        <source>literal with clamped memory</source>
        <translation>wörtlich, mit begrenztem Speicher</translation>
    </message>
    <message>
        <source>arctangent</source>
        <translation>Arkustangens</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>one sample</source>
        <translation>ein Abtastwert</translation>
    </message>
    <message>
        <source>two samples</source>
        <translation>zwei Abtastwerte</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>d-axis</source>
        <translation>d-Achse</translation>
    </message>
    <message>
        <source>run</source>
        <translation>Betrieb</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>staircase</source>
        <translation>Treppe</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>Chirp</translation>
    </message>
    <message>
        <source>multisine</source>
        <translation>Multisinus</translation>
    </message>
    <message>
        <source>plateaus</source>
        <translation>Plateaus</translation>
    </message>
    <message>
        <source>filling</source>
        <translation>füllt sich</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>full</source>
        <translation>voll</translation>
    </message>
    <message>
        <source>immediate</source>
        <translation>sofort</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>reference start</source>
        <translation>Start des Verlaufs</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>steigend</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
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
        <source>voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>transconductance</source>
        <translation>Steilheit</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>Trägheitsmoment</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>inductance</source>
        <translation>Induktivität</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>its</source>
        <translation>sein</translation>
    </message>
    <message>
        <source>their</source>
        <translation>ihr</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>Designed: damping 0.06 at 15 rad/s, computed correctly</source>
        <translation>Entworfen: Dämpfung 0,06 bei 15 rad/s, richtig berechnet</translation>
    </message>
    <message>
        <source>Micro-step: error in degrees, 5 A/deg, 0.05 A/(deg s)</source>
        <translation>Mikroschritt: Fehler in Grad, 5 A/°, 0,05 A/(°·s)</translation>
    </message>
    <message>
        <source>Published gains read in degrees: 10 A/deg, 0.1 A/(deg s)</source>
        <translation>Veröffentlichte Werte in Grad gelesen: 10 A/°, 0,1 A/(°·s)</translation>
    </message>
    <message>
        <source>Published: 10 A/rad, 0.1 A/(rad s)</source>
        <translation>Veröffentlicht: 10 A/rad, 0,1 A/(rad s)</translation>
    </message>
    <message>
        <source>Recommended: feed-forward and micro-step assist</source>
        <translation>Empfohlen: Vorsteuerung und Mikroschritthilfe</translation>
    </message>
    <message>
        <source>Two-phase Halbach-cylinder motor</source>
        <translation>Zweiphasiger Halbach-Zylinder-Motor</translation>
    </message>
    <message>
        <source>the feedback closes an algebraic loop with 1 + L = 0</source>
        <translation>die Rückführung schließt eine algebraische Schleife mit 1 + L = 0</translation>
    </message>
    <message>
        <source>a step response needs at least two samples, each with its time</source>
        <translation>eine Sprungantwort braucht mindestens zwei Abtastwerte, jeder mit seiner Zeit</translation>
    </message>
    <message>
        <source>the step response holds a value that is not finite</source>
        <translation>die Sprungantwort enthält einen Wert, der nicht endlich ist</translation>
    </message>
    <message>
        <source>the step has no height</source>
        <translation>der Sprung hat keine Höhe</translation>
    </message>
    <message>
        <source>the times of the step response are not ascending</source>
        <translation>die Zeiten der Sprungantwort steigen nicht an</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; is read only</source>
        <translation>der Parameter „{}“ ist nur lesbar</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>lassen Sie ihn weg</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; needs a finite number</source>
        <translation>der Parameter „{}“ braucht eine endliche Zahl</translation>
    </message>
    <message>
        <source>give a value from {} to {} {}</source>
        <translation>geben Sie einen Wert von {} bis {} {} an</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; = {} {} is out of range</source>
        <translation>der Parameter „{}“ = {} {} ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>allowed is {} to {} {}</source>
        <translation>erlaubt ist {} bis {} {}</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; = {} needs a whole number</source>
        <translation>der Parameter „{}“ = {} muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>allowed is {} to {}</source>
        <translation>erlaubt ist {} bis {}</translation>
    </message>
    <message>
        <source>count or state</source>
        <translation>Anzahl oder Zustand</translation>
    </message>
    <message>
        <source>angular speed</source>
        <translation>Winkelgeschwindigkeit</translation>
    </message>
    <message>
        <source>angular acceleration</source>
        <translation>Winkelbeschleunigung</translation>
    </message>
    <message>
        <source>flux density</source>
        <translation>Flussdichte</translation>
    </message>
    <message>
        <source>stray field per current</source>
        <translation>Streufeld je Strom</translation>
    </message>
    <message>
        <source>temperature difference</source>
        <translation>Temperaturdifferenz</translation>
    </message>
    <message>
        <source>torque constant</source>
        <translation>Drehmomentkonstante</translation>
    </message>
    <message>
        <source>viscous damping</source>
        <translation>viskose Dämpfung</translation>
    </message>
    <message>
        <source>acceleration per current</source>
        <translation>Beschleunigung je Strom</translation>
    </message>
    <message>
        <source>proportional gain</source>
        <translation>Proportionalverstärkung</translation>
    </message>
    <message>
        <source>integral gain</source>
        <translation>Integralverstärkung</translation>
    </message>
    <message>
        <source>derivative gain</source>
        <translation>Differentialverstärkung</translation>
    </message>
    <message>
        <source>acceleration feed-forward</source>
        <translation>Beschleunigungsvorsteuerung</translation>
    </message>
    <message>
        <source>current slope</source>
        <translation>Stromänderungsrate</translation>
    </message>
    <message>
        <source>zeta = {} at {} rad/s is out of reach of a PI position loop on this motor: zeta &lt;= c/(2 J omega) = {}</source>
        <translation>zeta = {} bei {} rad/s ist für einen PI-Lageregler an diesem Motor unerreichbar: zeta &lt;= c/(2 J omega) = {}</translation>
    </message>
    <message>
        <source>lower zeta or omega, or use method bandwidth or phase-margin, which add derivative action</source>
        <translation>verringern Sie zeta oder omega, oder verwenden Sie das Verfahren bandwidth oder phase-margin, die einen D-Anteil hinzufügen</translation>
    </message>
    <message>
        <source>method bandwidth needs a target bandwidth</source>
        <translation>das Verfahren bandwidth braucht eine Zielbandbreite</translation>
    </message>
    <message>
        <source>add --bandwidth-hz HZ</source>
        <translation>ergänzen Sie --bandwidth-hz HZ</translation>
    </message>
    <message>
        <source>a bandwidth of {} Hz is not possible with this motor at {} Hz sampling and {} samples of delay</source>
        <translation>eine Bandbreite von {} Hz ist mit diesem Motor bei {} Hz Abtastung und {} Abtastwerten Totzeit nicht möglich</translation>
    </message>
    <message>
        <source>choose {} to {} Hz</source>
        <translation>wählen Sie {} bis {} Hz</translation>
    </message>
    <message>
        <source>method phase-margin needs a target margin</source>
        <translation>das Verfahren phase-margin braucht eine Zielreserve</translation>
    </message>
    <message>
        <source>add --phase-margin-deg DEG</source>
        <translation>ergänzen Sie --phase-margin-deg GRAD</translation>
    </message>
    <message>
        <source>no position loop on this motor has a phase margin of {} deg and a gain margin of 2{}</source>
        <translation>kein Lageregelkreis an diesem Motor hat eine Phasenreserve von {} Grad und eine Amplitudenreserve von 2{}</translation>
    </message>
    <message>
        <source> at {} rad/s</source>
        <translation> bei {} rad/s</translation>
    </message>
    <message>
        <source>ask for 30 to 60 deg, or leave the crossover to the program</source>
        <translation>verlangen Sie 30 bis 60 Grad, oder überlassen Sie die Durchtrittsfrequenz dem Programm</translation>
    </message>
    <message>
        <source>the target {} is not a finite number</source>
        <translation>das Ziel {} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>method {} does not read the target {}</source>
        <translation>das Verfahren {} verwendet das Ziel {} nicht</translation>
    </message>
    <message>
        <source>leave it out, or choose the method that reads it</source>
        <translation>lassen Sie es weg, oder wählen Sie das Verfahren, das es verwendet</translation>
    </message>
    <message>
        <source>there is no design method &apos;{}&apos;</source>
        <translation>ein Entwurfsverfahren „{}“ gibt es nicht</translation>
    </message>
    <message>
        <source>choose one of: {}</source>
        <translation>wählen Sie eines von: {}</translation>
    </message>
    <message>
        <source>PI with the asked dominant pair, as far as the motor damps</source>
        <translation>PI mit dem verlangten dominanten Polpaar, soweit der Motor dämpft</translation>
    </message>
    <message>
        <source>the recommended shape at the asked closed-loop bandwidth</source>
        <translation>die empfohlene Form mit der verlangten Bandbreite des geschlossenen Kreises</translation>
    </message>
    <message>
        <source>the stiffest loop with the asked phase margin</source>
        <translation>der steifste Regelkreis mit der verlangten Phasenreserve</translation>
    </message>
    <message>
        <source>10 A/rad and 0.1 A/(rad s), as printed</source>
        <translation>10 A/rad und 0,1 A/(rad s), wie gedruckt</translation>
    </message>
    <message>
        <source>zeta = 0.06 at 15 rad/s, as the source meant it</source>
        <translation>zeta = 0,06 bei 15 rad/s, wie es die Quelle meinte</translation>
    </message>
    <message>
        <source>5 A/deg and 0.05 A/(deg s), for steps of a few tenths of a degree</source>
        <translation>5 A/° und 0,05 A/(°·s), für Sprünge von einigen Zehntelgrad</translation>
    </message>
    <message>
        <source>the printed numbers read per degree; large steps end in a limit cycle</source>
        <translation>die gedruckten Zahlen je Grad gelesen; große Sprünge enden in einem Grenzzyklus</translation>
    </message>
    <message>
        <source>a step needs a finite height that is not zero</source>
        <translation>ein Sprung braucht eine endliche Höhe, die nicht null ist</translation>
    </message>
    <message>
        <source>a step response of {} s is not possible</source>
        <translation>eine Sprungantwort von {} s ist nicht möglich</translation>
    </message>
    <message>
        <source>the step response of this unstable loop grows beyond all numbers</source>
        <translation>die Sprungantwort dieses instabilen Regelkreises wächst über alle Zahlen</translation>
    </message>
    <message>
        <source>an integral time of zero is an infinite integral gain</source>
        <translation>eine Nachstellzeit von null ist eine unendliche Integralverstärkung</translation>
    </message>
    <message>
        <source>no integral action is an infinite integral time</source>
        <translation>kein I-Anteil ist eine unendliche Nachstellzeit</translation>
    </message>
    <message>
        <source>a controller without proportional gain cannot be written with times</source>
        <translation>ein Regler ohne P-Anteil lässt sich nicht mit Zeiten schreiben</translation>
    </message>
    <message>
        <source>keep the parallel form</source>
        <translation>behalten Sie die Parallelform</translation>
    </message>
    <message>
        <source>the series form has real zeros only, these gains have complex ones (T_i &lt; 4 T_d)</source>
        <translation>die Reihenform hat nur reelle Nullstellen, diese Reglerparameter haben komplexe (T_i &lt; 4 T_d)</translation>
    </message>
    <message>
        <source>keep the parallel or the standard form</source>
        <translation>behalten Sie die Parallel- oder die Standardform</translation>
    </message>
    <message>
        <source>a gain is not a finite number</source>
        <translation>eine Verstärkung ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a constant of the motor model is not a finite number</source>
        <translation>eine Konstante des Motormodells ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>phi/J = {}, c/J = {}, K_f/phi = {} is no motor: torque per ampere must be positive, damping and friction not negative</source>
        <translation>phi/J = {}, c/J = {}, K_f/phi = {} sind kein Motor: das Drehmoment je Ampere muss positiv sein, Dämpfung und Reibung nicht negativ</translation>
    </message>
    <message>
        <source>a delay of {} samples is not between 0 and {}</source>
        <translation>eine Totzeit von {} Abtastwerten liegt nicht zwischen 0 und {}</translation>
    </message>
    <message>
        <source>the covariance of the model is not a covariance</source>
        <translation>die Kovarianz des Modells ist keine Kovarianz</translation>
    </message>
    <message>
        <source>it must be symmetric and positive semi-definite: identify the motor again</source>
        <translation>sie muss symmetrisch und positiv semidefinit sein: identifizieren Sie den Motor neu</translation>
    </message>
    <message>
        <source>{} draws are not between {} and {}</source>
        <translation>{} Stichproben liegen nicht zwischen {} und {}</translation>
    </message>
    <message>
        <source>the covariance does not have the size of the parameters</source>
        <translation>die Kovarianz hat nicht die Größe der Parameter</translation>
    </message>
    <message>
        <source>the model or its covariance holds a value that is not finite</source>
        <translation>das Modell oder seine Kovarianz enthält einen Wert, der nicht endlich ist</translation>
    </message>
    <message>
        <source>the added inertia must be more than zero</source>
        <translation>die zugefügte Trägheit muss größer als null sein</translation>
    </message>
    <message>
        <source>give it in kg*m^2, e.g. 2e-4</source>
        <translation>geben Sie sie in kg*m^2 an, z. B. 2e-4</translation>
    </message>
    <message>
        <source>the added inertia does not show above the errors of both runs</source>
        <translation>die zugefügte Trägheit hebt sich nicht von den Fehlern beider Läufe ab</translation>
    </message>
    <message>
        <source>fix a larger known inertia to the rotor, about as large as the rotor&apos;s own, and check that the first run was made without it</source>
        <translation>befestigen Sie eine größere bekannte Trägheit am Rotor, etwa so groß wie die des Rotors, und prüfen Sie, dass der erste Lauf ohne sie gemacht wurde</translation>
    </message>
    <message>
        <source>no repeated points to judge the model by</source>
        <translation>keine wiederholten Punkte, um das Modell zu beurteilen</translation>
    </message>
    <message>
        <source>visit some currents twice</source>
        <translation>fahren Sie einige Ströme zweimal an</translation>
    </message>
    <message>
        <source>all motion that could be used was under one current (coast-downs are missing or too short): torque and friction cannot be told apart</source>
        <translation>alle brauchbare Bewegung geschah unter einem einzigen Strom (Ausläufe fehlen oder sind zu kurz): Drehmoment und Reibung lassen sich nicht trennen</translation>
    </message>
    <message>
        <source>spin faster before the coast-down, or add a second current</source>
        <translation>drehen Sie vor dem Auslauf schneller, oder fügen Sie einen zweiten Strom hinzu</translation>
    </message>
    <message>
        <source>the d-axis current does not change</source>
        <translation>der Strom der d-Achse ändert sich nicht</translation>
    </message>
    <message>
        <source>step it to both signs</source>
        <translation>lassen Sie ihn in beide Vorzeichen springen</translation>
    </message>
    <message>
        <source>the ramp is too short</source>
        <translation>die Rampe ist zu kurz</translation>
    </message>
    <message>
        <source>record it from its start</source>
        <translation>zeichnen Sie sie von ihrem Anfang an auf</translation>
    </message>
    <message>
        <source>the rotor did not break loose during the ramp</source>
        <translation>der Rotor riss sich während der Rampe nicht los</translation>
    </message>
    <message>
        <source>ramp to a higher current, from rest</source>
        <translation>steigern Sie aus dem Stillstand bis zu einem größeren Strom</translation>
    </message>
    <message>
        <source>turn the rotor through several whole turns</source>
        <translation>drehen Sie den Rotor mehrere ganze Umdrehungen</translation>
    </message>
    <message>
        <source>the Hall readings do not change</source>
        <translation>die Hall-Messwerte ändern sich nicht</translation>
    </message>
    <message>
        <source>the Hall readings do not lie on an ellipse</source>
        <translation>die Hall-Messwerte liegen nicht auf einer Ellipse</translation>
    </message>
    <message>
        <source>too few Hall readings for an ellipse</source>
        <translation>zu wenige Hall-Messwerte für eine Ellipse</translation>
    </message>
    <message>
        <source>record longer</source>
        <translation>zeichnen Sie länger auf</translation>
    </message>
    <message>
        <source>parts of the record do not go round</source>
        <translation>Teile der Aufzeichnung gehen nicht rundum</translation>
    </message>
    <message>
        <source>a plateau stands still or turns against its current</source>
        <translation>ein Plateau steht still oder dreht gegen seinen Strom</translation>
    </message>
    <message>
        <source>leave plateaus that stop out of the fit</source>
        <translation>lassen Sie Plateaus, die stehen bleiben, aus der Anpassung weg</translation>
    </message>
    <message>
        <source>no usable plateau</source>
        <translation>kein brauchbares Plateau</translation>
    </message>
    <message>
        <source>use currents above the breakaway current</source>
        <translation>verwenden Sie Ströme über dem Losbrechstrom</translation>
    </message>
    <message>
        <source>too few plateaus to know their scatter</source>
        <translation>zu wenige Plateaus, um ihre Streuung zu kennen</translation>
    </message>
    <message>
        <source>visit at least three currents in one direction, four in both</source>
        <translation>fahren Sie mindestens drei Ströme in einer Richtung an, vier bei beiden</translation>
    </message>
    <message>
        <source>the speed does not grow with the current</source>
        <translation>die Drehzahl wächst nicht mit dem Strom</translation>
    </message>
    <message>
        <source>check the sign of the current and that the plateaus are steady</source>
        <translation>prüfen Sie das Vorzeichen des Stroms, und dass die Plateaus stationär sind</translation>
    </message>
    <message>
        <source>not identifiable</source>
        <translation>nicht identifizierbar</translation>
    </message>
    <message>
        <source>a value of the fit is not a finite number</source>
        <translation>ein Wert der Anpassung ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>look for gaps or faults in the recording</source>
        <translation>suchen Sie Lücken oder Fehler in der Aufzeichnung</translation>
    </message>
    <message>
        <source>{} usable points cannot decide {} coefficients</source>
        <translation>{} brauchbare Punkte können {} Koeffizienten nicht bestimmen</translation>
    </message>
    <message>
        <source>measure more points</source>
        <translation>messen Sie mehr Punkte</translation>
    </message>
    <message>
        <source>the points do not tell the coefficients apart</source>
        <translation>die Punkte trennen die Koeffizienten nicht</translation>
    </message>
    <message>
        <source>visit more different currents, speeds or directions</source>
        <translation>fahren Sie mehr verschiedene Ströme, Drehzahlen oder Richtungen an</translation>
    </message>
    <message>
        <source>the recording holds no stretch of motion under constant current</source>
        <translation>die Aufzeichnung enthält keinen Bewegungsabschnitt unter konstantem Strom</translation>
    </message>
    <message>
        <source>hold each current for a second or more, well above the breakaway current</source>
        <translation>halten Sie jeden Strom eine Sekunde oder länger, deutlich über dem Losbrechstrom</translation>
    </message>
    <message>
        <source>a stretch of motion has too few samples</source>
        <translation>ein Bewegungsabschnitt hat zu wenige Abtastwerte</translation>
    </message>
    <message>
        <source>record faster</source>
        <translation>zeichnen Sie schneller auf</translation>
    </message>
    <message>
        <source>an angle of the recording is not a number</source>
        <translation>ein Winkel der Aufzeichnung ist keine Zahl</translation>
    </message>
    <message>
        <source>cut the damaged rows out</source>
        <translation>schneiden Sie die beschädigten Zeilen heraus</translation>
    </message>
    <message>
        <source>the damping of the motion cannot be decided</source>
        <translation>die Dämpfung der Bewegung lässt sich nicht bestimmen</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs over a wider range of speed</source>
        <translation>zeichnen Sie Hochläufe und Ausläufe über einen weiteren Drehzahlbereich auf</translation>
    </message>
    <message>
        <source>the segments do not bend: the damping is undecided</source>
        <translation>die Abschnitte krümmen sich nicht: die Dämpfung bleibt unbestimmt</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs, not only steady motion</source>
        <translation>zeichnen Sie Hochläufe und Ausläufe auf, nicht nur stationäre Bewegung</translation>
    </message>
    <message>
        <source>the columns of the recording differ in length</source>
        <translation>die Spalten der Aufzeichnung sind verschieden lang</translation>
    </message>
    <message>
        <source>the recording holds a value that is not a number</source>
        <translation>die Aufzeichnung enthält einen Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>the time of the recording does not increase</source>
        <translation>die Zeit der Aufzeichnung nimmt nicht zu</translation>
    </message>
    <message>
        <source>sort the rows and remove doubles</source>
        <translation>sortieren Sie die Zeilen und entfernen Sie doppelte</translation>
    </message>
    <message>
        <source>a plateau has fewer than three samples</source>
        <translation>ein Plateau hat weniger als drei Abtastwerte</translation>
    </message>
    <message>
        <source>dwell longer</source>
        <translation>verweilen Sie länger</translation>
    </message>
    <message>
        <source>a sample of a plateau is not a finite number</source>
        <translation>ein Abtastwert eines Plateaus ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>look for faults in the recording</source>
        <translation>suchen Sie Fehler in der Aufzeichnung</translation>
    </message>
    <message>
        <source>a plateau is shorter than two windows of the steadiness test</source>
        <translation>ein Plateau ist kürzer als zwei Fenster der Stationaritätsprüfung</translation>
    </message>
    <message>
        <source>the fit hangs on single points</source>
        <translation>die Anpassung hängt an einzelnen Punkten</translation>
    </message>
    <message>
        <source>a record has too few samples</source>
        <translation>eine Aufzeichnung hat zu wenige Abtastwerte</translation>
    </message>
    <message>
        <source>record faster or longer</source>
        <translation>zeichnen Sie schneller oder länger auf</translation>
    </message>
    <message>
        <source>no run-up and no coast-down</source>
        <translation>kein Hochlauf und kein Auslauf</translation>
    </message>
    <message>
        <source>record some</source>
        <translation>zeichnen Sie welche auf</translation>
    </message>
    <message>
        <source>an angle is not a number</source>
        <translation>ein Winkel ist keine Zahl</translation>
    </message>
    <message>
        <source>the records do not tell torque, friction and damping apart</source>
        <translation>die Aufzeichnungen trennen Drehmoment, Reibung und Dämpfung nicht</translation>
    </message>
    <message>
        <source>add a coast-down or a run-up at a second current</source>
        <translation>fügen Sie einen Auslauf oder einen Hochlauf mit einem zweiten Strom hinzu</translation>
    </message>
    <message>
        <source>the pre-warp frequency of {} rad/s is not between 0 and the Nyquist frequency of {} rad/s</source>
        <translation>die Vorverzerrungsfrequenz von {} rad/s liegt nicht zwischen 0 und der Nyquist-Frequenz von {} rad/s</translation>
    </message>
    <message>
        <source>the system is already sampled</source>
        <translation>das System ist bereits abgetastet</translation>
    </message>
    <message>
        <source>the bilinear rule has no solution: a pole lies at 2/T</source>
        <translation>die bilineare Regel hat keine Lösung: ein Pol liegt bei 2/T</translation>
    </message>
    <message>
        <source>choose a shorter period</source>
        <translation>wählen Sie eine kürzere Periode</translation>
    </message>
    <message>
        <source>the transfer function is already sampled</source>
        <translation>die Übertragungsfunktion ist bereits abgetastet</translation>
    </message>
    <message>
        <source>{} rad/s lies outside the frequency range of the system</source>
        <translation>{} rad/s liegt außerhalb des Frequenzbereichs des Systems</translation>
    </message>
    <message>
        <source>a step response of {} s in steps of {} s is not possible</source>
        <translation>eine Sprungantwort von {} s in Schritten von {} s ist nicht möglich</translation>
    </message>
    <message>
        <source>state space matrices do not fit: A {}x{}, B {}x{}, C {}x{}, D {}x{}</source>
        <translation>die Zustandsraummatrizen passen nicht zusammen: A {}x{}, B {}x{}, C {}x{}, D {}x{}</translation>
    </message>
    <message>
        <source>a state space matrix holds a value that is not finite</source>
        <translation>eine Zustandsraummatrix enthält einen Wert, der nicht endlich ist</translation>
    </message>
    <message>
        <source>there is no path from input {} to output {}</source>
        <translation>es gibt keinen Pfad vom Eingang {} zum Ausgang {}</translation>
    </message>
    <message>
        <source>the sample period is not a finite number</source>
        <translation>die Abtastperiode ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a sample period of {} s is not possible</source>
        <translation>eine Abtastperiode von {} s ist nicht möglich</translation>
    </message>
    <message>
        <source>give a positive period in seconds</source>
        <translation>geben Sie eine positive Periode in Sekunden an</translation>
    </message>
    <message>
        <source>sampled at {} s</source>
        <translation>mit {} s abgetastet</translation>
    </message>
    <message>
        <source>a system that is {} cannot be combined with one that is {}</source>
        <translation>ein System, das {} ist, lässt sich nicht mit einem verbinden, das {} ist</translation>
    </message>
    <message>
        <source>discretize one of them first</source>
        <translation>diskretisieren Sie zuerst eines davon</translation>
    </message>
    <message>
        <source>a coefficient of the transfer function is not a finite number</source>
        <translation>ein Koeffizient der Übertragungsfunktion ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the denominator of the transfer function is zero</source>
        <translation>der Nenner der Übertragungsfunktion ist null</translation>
    </message>
    <message>
        <source>the transfer function has more zeros than poles</source>
        <translation>die Übertragungsfunktion hat mehr Nullstellen als Pole</translation>
    </message>
    <message>
        <source>add the filter or the actuator that every real system has</source>
        <translation>fügen Sie das Filter oder den Aktor hinzu, den jedes wirkliche System hat</translation>
    </message>
    <message>
        <source>one of the two systems needs a delay</source>
        <translation>eines der beiden Systeme braucht eine Totzeit</translation>
    </message>
    <message>
        <source>period or duration of the excitation is not a finite number</source>
        <translation>Periode oder Dauer der Anregung ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>an excitation of {} s in steps of {} s is not possible</source>
        <translation>eine Anregung von {} s in Schritten von {} s ist nicht möglich</translation>
    </message>
    <message>
        <source>a frequency of the excitation is not a finite number</source>
        <translation>eine Frequenz der Anregung ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>{} to {} Hz does not lie between 0 and the Nyquist frequency of {} Hz</source>
        <translation>{} bis {} Hz liegt nicht zwischen 0 und der Nyquist-Frequenz von {} Hz</translation>
    </message>
    <message>
        <source>{} to {} Hz does not hold {} lines {} Hz apart</source>
        <translation>{} bis {} Hz enthält keine {} Linien im Abstand von {} Hz</translation>
    </message>
    <message>
        <source>excite longer, widen the band or ask for fewer lines</source>
        <translation>regen Sie länger an, verbreitern Sie das Band, oder verlangen Sie weniger Linien</translation>
    </message>
    <message>
        <source>a binary sequence of {} stages held for {} samples is not possible</source>
        <translation>eine Binärfolge von {} Stufen, gehalten für {} Abtastwerte, ist nicht möglich</translation>
    </message>
    <message>
        <source>2 to 16 stages, 1 to 10000 samples</source>
        <translation>2 bis 16 Stufen, 1 bis 10000 Abtastwerte</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is of no format that can be read</source>
        <translation>„{}“ hat kein lesbares Format</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is of no format that can be written</source>
        <translation>„{}“ hat kein schreibbares Format</translation>
    </message>
    <message>
        <source>the recording has no signal &apos;{}&apos;</source>
        <translation>die Aufzeichnung hat kein Signal „{}“</translation>
    </message>
    <message>
        <source>it has {}</source>
        <translation>sie hat {}</translation>
    </message>
    <message>
        <source>the interval needs numbers</source>
        <translation>das Intervall braucht Zahlen</translation>
    </message>
    <message>
        <source>give seconds, e.g. --from 1.5</source>
        <translation>geben Sie Sekunden an, z. B. --from 1.5</translation>
    </message>
    <message>
        <source>the recording has no rows in this interval</source>
        <translation>die Aufzeichnung hat in diesem Intervall keine Zeilen</translation>
    </message>
    <message>
        <source>it has no rows at all</source>
        <translation>sie hat gar keine Zeilen</translation>
    </message>
    <message>
        <source>it reaches from {} s to {} s</source>
        <translation>sie reicht von {} s bis {} s</translation>
    </message>
    <message>
        <source>{} {} and outside {} to {} {}</source>
        <translation>{} {} und außerhalb von {} bis {} {}</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>stopped from here: {} was {} at {} s</source>
        <translation>von hier gestoppt: {} war {} bei {} s</translation>
    </message>
    <message>
        <source>find the cause, then clear the stop before arming again</source>
        <translation>finden Sie die Ursache, dann heben Sie den Stopp auf, bevor Sie wieder freigeben</translation>
    </message>
    <message>
        <source>a recording begins with the line time_s,SIGNAL_UNIT,...</source>
        <translation>eine Aufzeichnung beginnt mit der Zeile time_s,SIGNAL_EINHEIT,...</translation>
    </message>
    <message>
        <source>the first column is not time_s</source>
        <translation>die erste Spalte ist nicht time_s</translation>
    </message>
    <message>
        <source>{} columns</source>
        <translation>{} Spalten</translation>
    </message>
    <message>
        <source>at most {} are read</source>
        <translation>höchstens {} werden gelesen</translation>
    </message>
    <message>
        <source>a column has no name</source>
        <translation>eine Spalte hat keinen Namen</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is there twice</source>
        <translation>die Spalte „{}“ kommt zweimal vor</translation>
    </message>
    <message>
        <source>{} fields where the header has {}</source>
        <translation>{} Felder, wo der Kopf {} hat</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged</source>
        <translation>die Datei ist vielleicht abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number</source>
        <translation>„{}“ ist keine Zahl</translation>
    </message>
    <message>
        <source>numbers are written like -1.5e-3, with a point</source>
        <translation>Zahlen werden wie -1.5e-3 geschrieben, mit Punkt</translation>
    </message>
    <message>
        <source>the time does not increase</source>
        <translation>die Zeit nimmt nicht zu</translation>
    </message>
    <message>
        <source>sort the rows by time_s</source>
        <translation>sortieren Sie die Zeilen nach time_s</translation>
    </message>
    <message>
        <source>at most {} are read; cut the file into pieces that each begin with its first line</source>
        <translation>höchstens {} werden gelesen; teilen Sie die Datei in Stücke, die jeweils mit ihrer ersten Zeile beginnen</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>a recording begins with the line time_s,...</source>
        <translation>eine Aufzeichnung beginnt mit der Zeile time_s,...</translation>
    </message>
    <message>
        <source>cannot read &apos;{}&apos;: {}</source>
        <translation>„{}“ kann nicht gelesen werden: {}</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>prüfen Sie den Pfad</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has {} octets</source>
        <translation>„{}“ hat {} Byte</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was changed since it was recorded (SHA-256)</source>
        <translation>„{}“ wurde seit der Aufzeichnung geändert (SHA-256)</translation>
    </message>
    <message>
        <source>&apos;{}&apos; holds no whole row</source>
        <translation>„{}“ enthält keine ganze Zeile</translation>
    </message>
    <message>
        <source>nothing was recorded before the interruption; the file can be removed</source>
        <translation>vor der Unterbrechung wurde nichts aufgezeichnet; die Datei kann gelöscht werden</translation>
    </message>
    <message>
        <source>recording interrupted</source>
        <translation>Aufzeichnung unterbrochen</translation>
    </message>
    <message>
        <source>{}: octet {}: {}</source>
        <translation>{}: Byte {}: {}</translation>
    </message>
    <message>
        <source>remove the sidecar to read the data without it</source>
        <translation>entfernen Sie die Begleitdatei, um die Daten ohne sie zu lesen</translation>
    </message>
    <message>
        <source>{}: &quot;schema&quot; is not &quot;{}&quot;</source>
        <translation>{}: „schema“ ist nicht „{}“</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;: {}</source>
        <translation>„{}“ kann nicht geschrieben werden: {}</translation>
    </message>
    <message>
        <source>check that the folder can be written and the disk has room</source>
        <translation>prüfen Sie, dass der Ordner beschreibbar ist und der Datenträger Platz hat</translation>
    </message>
    <message>
        <source>cannot rename &apos;{}&apos; to &apos;{}&apos;: {}</source>
        <translation>„{}“ kann nicht in „{}“ umbenannt werden: {}</translation>
    </message>
    <message>
        <source>check that the folder can be written</source>
        <translation>prüfen Sie, dass der Ordner beschreibbar ist</translation>
    </message>
    <message>
        <source>cannot create the folder &apos;{}&apos;</source>
        <translation>der Ordner „{}“ kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>give a folder that can be written</source>
        <translation>geben Sie einen beschreibbaren Ordner an</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a folder</source>
        <translation>„{}“ ist ein Ordner</translation>
    </message>
    <message>
        <source>give the name of a file</source>
        <translation>geben Sie den Namen einer Datei an</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is being written by another program</source>
        <translation>„{}“ wird von einem anderen Programm geschrieben</translation>
    </message>
    <message>
        <source>wait for its end or give another name</source>
        <translation>warten Sie dessen Ende ab oder geben Sie einen anderen Namen an</translation>
    </message>
    <message>
        <source>a recording cannot be changed, armed or stopped</source>
        <translation>eine Aufzeichnung kann nicht geändert, freigegeben oder gestoppt werden</translation>
    </message>
    <message>
        <source>use a real or simulated device</source>
        <translation>verwenden Sie ein wirkliches oder simuliertes Gerät</translation>
    </message>
    <message>
        <source>the recording has no parameter &apos;{}&apos;</source>
        <translation>die Aufzeichnung hat keinen Parameter „{}“</translation>
    </message>
    <message>
        <source>list the names with: halbench describe replay:FILE</source>
        <translation>die Namen listet: halbench describe replay:DATEI</translation>
    </message>
    <message>
        <source>the recording of {} Hz cannot be played at {} Hz</source>
        <translation>die Aufzeichnung mit {} Hz kann nicht mit {} Hz abgespielt werden</translation>
    </message>
    <message>
        <source>give a rate that divides {} Hz</source>
        <translation>geben Sie eine Rate an, die {} Hz teilt</translation>
    </message>
    <message>
        <source>the recording ends at {} s</source>
        <translation>die Aufzeichnung endet bei {} s</translation>
    </message>
    <message>
        <source>ask for a shorter time</source>
        <translation>verlangen Sie eine kürzere Zeit</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has fewer than two rows</source>
        <translation>„{}“ hat weniger als zwei Zeilen</translation>
    </message>
    <message>
        <source>give a recording with data</source>
        <translation>geben Sie eine Aufzeichnung mit Daten an</translation>
    </message>
    <message>
        <source>device address &apos;{}&apos;: {} at character {}</source>
        <translation>Geräteadresse „{}“: {} bei Zeichen {}</translation>
    </message>
    <message>
        <source>the device address has {} characters</source>
        <translation>die Geräteadresse hat {} Zeichen</translation>
    </message>
    <message>
        <source>at most {} are allowed</source>
        <translation>höchstens {} sind erlaubt</translation>
    </message>
    <message>
        <source>the device address has a control character at character {}</source>
        <translation>die Geräteadresse hat ein Steuerzeichen bei Zeichen {}</translation>
    </message>
    <message>
        <source>write it like sim:htm?seed=7</source>
        <translation>schreiben Sie sie wie sim:htm?seed=7</translation>
    </message>
    <message>
        <source>a scheme and &apos;:&apos; are missing</source>
        <translation>Schema und „:“ fehlen</translation>
    </message>
    <message>
        <source>write it like sim:htm, tcp:HOST:PORT or replay:FILE</source>
        <translation>schreiben Sie sie wie sim:htm, tcp:HOST:PORT oder replay:DATEI</translation>
    </message>
    <message>
        <source>device address &apos;{}&apos;: unknown scheme &apos;{}&apos;</source>
        <translation>Geräteadresse „{}“: unbekanntes Schema „{}“</translation>
    </message>
    <message>
        <source>known are {}</source>
        <translation>bekannt sind {}</translation>
    </message>
    <message>
        <source>a key has letters, digits and &apos;_&apos; only</source>
        <translation>ein Schlüssel hat nur Buchstaben, Ziffern und „_“</translation>
    </message>
    <message>
        <source>write options as KEY=VALUE</source>
        <translation>schreiben Sie Optionen als SCHLÜSSEL=WERT</translation>
    </message>
    <message>
        <source>a key is missing</source>
        <translation>ein Schlüssel fehlt</translation>
    </message>
    <message>
        <source>write options as KEY=VALUE, joined by &apos;&amp;&apos;</source>
        <translation>schreiben Sie Optionen als SCHLÜSSEL=WERT, verbunden mit „&amp;“</translation>
    </message>
    <message>
        <source>&apos;=&apos; is missing</source>
        <translation>„=“ fehlt</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>ein Wert fehlt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is given twice</source>
        <translation>„{}“ ist zweimal angegeben</translation>
    </message>
    <message>
        <source>give each key once</source>
        <translation>geben Sie jeden Schlüssel einmal an</translation>
    </message>
    <message>
        <source>the address is missing</source>
        <translation>die Adresse fehlt</translation>
    </message>
    <message>
        <source>write it like sim:htm or tcp:HOST:PORT</source>
        <translation>schreiben Sie sie wie sim:htm oder tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: unknown option &apos;{}&apos;</source>
        <translation>Gerät „{}“: unbekannte Option „{}“</translation>
    </message>
    <message>
        <source>must be &quot;{}&quot;</source>
        <translation>muss „{}“ sein</translation>
    </message>
    <message>
        <source>must name the model</source>
        <translation>muss das Modell nennen</translation>
    </message>
    <message>
        <source>compare with resources/devices/htm.json</source>
        <translation>vergleichen Sie mit resources/devices/htm.json</translation>
    </message>
    <message>
        <source>is not a key of a profile</source>
        <translation>ist kein Schlüssel eines Profils</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>muss ein Text sein</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>muss eine Zahl sein</translation>
    </message>
    <message>
        <source>must be a list of texts</source>
        <translation>muss eine Liste von Texten sein</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>muss ein Objekt sein</translation>
    </message>
    <message>
        <source>correct the JSON</source>
        <translation>berichtigen Sie das JSON</translation>
    </message>
    <message>
        <source>{}: a profile is one JSON object</source>
        <translation>{}: ein Profil ist ein einziges JSON-Objekt</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>muss true oder false sein</translation>
    </message>
    <message>
        <source>is not a key of an axis</source>
        <translation>ist kein Schlüssel einer Achse</translation>
    </message>
    <message>
        <source>must be a positive number</source>
        <translation>muss eine positive Zahl sein</translation>
    </message>
    <message>
        <source>must be &quot;rad&quot; or &quot;m&quot;</source>
        <translation>muss &quot;rad&quot; oder &quot;m&quot; sein</translation>
    </message>
    <message>
        <source>must be a unit of the program, e.g. &quot;N&quot;</source>
        <translation>muss eine Einheit des Programms sein, z. B. &quot;N&quot;</translation>
    </message>
    <message>
        <source>must be a role of this profile</source>
        <translation>muss eine Rolle dieses Profils sein</translation>
    </message>
    <message>
        <source>must be a list of axes</source>
        <translation>muss eine Liste von Achsen sein</translation>
    </message>
    <message>
        <source>must differ from the other axes</source>
        <translation>muss sich von den anderen Achsen unterscheiden</translation>
    </message>
    <message>
        <source>the device was unplugged</source>
        <translation>das Gerät wurde abgezogen</translation>
    </message>
    <message>
        <source>Connect it and open it again.</source>
        <translation>Schließen Sie es an und öffnen Sie es erneut.</translation>
    </message>
    <message>
        <source>the loopback to the simulated board is closed</source>
        <translation>die Verbindung zum simulierten Steuergerät ist geschlossen</translation>
    </message>
    <message>
        <source>Open the device again.</source>
        <translation>Öffnen Sie das Gerät erneut.</translation>
    </message>
    <message>
        <source>True rotor angle, known to the simulation only</source>
        <translation>Wahrer Rotorwinkel, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True rotor speed, known to the simulation only</source>
        <translation>Wahre Rotordrehzahl, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>there is no simulator &apos;sim:{}&apos;</source>
        <translation>einen Simulator „sim:{}“ gibt es nicht</translation>
    </message>
    <message>
        <source>Built simulators: {}.</source>
        <translation>Enthaltene Simulatoren: {}.</translation>
    </message>
    <message>
        <source>{}={} is out of range</source>
        <translation>{}={} ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>{}={} is not a number</source>
        <translation>{}={} ist keine Zahl</translation>
    </message>
    <message>
        <source>Write numbers like 2e-3. {}</source>
        <translation>Schreiben Sie Zahlen wie 2e-3. {}</translation>
    </message>
    <message>
        <source>seed={} is not a whole number</source>
        <translation>seed={} ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>A seed is a whole number from 0 to 18446744073709551615. Known keys: {}.</source>
        <translation>Ein Startwert ist eine ganze Zahl von 0 bis 18446744073709551615. Bekannte Schlüssel: {}.</translation>
    </message>
    <message>
        <source>{}={} is unknown</source>
        <translation>{}={} ist unbekannt</translation>
    </message>
    <message>
        <source>Allowed: {}={} and {}={}. {}</source>
        <translation>Erlaubt: {}={} und {}={}. {}</translation>
    </message>
    <message>
        <source>{} has no override &apos;{}&apos;</source>
        <translation>{} hat keine Einstellung „{}“</translation>
    </message>
    <message>
        <source>a message of {} octets was announced, 1 to {} are possible</source>
        <translation>eine Nachricht von {} Byte wurde angekündigt, 1 bis {} sind möglich</translation>
    </message>
    <message>
        <source>the other side does not speak this protocol</source>
        <translation>die Gegenseite spricht dieses Protokoll nicht</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not HOST:PORT</source>
        <translation>„{}“ ist nicht HOST:PORT</translation>
    </message>
    <message>
        <source>write it like 127.0.0.1:5555 or [::1]:5555, port 0 to 65535</source>
        <translation>schreiben Sie sie wie 127.0.0.1:5555 oder [::1]:5555, Port 0 bis 65535</translation>
    </message>
    <message>
        <source>check that the board is on and the address is right</source>
        <translation>prüfen Sie, dass das Steuergerät eingeschaltet und die Adresse richtig ist</translation>
    </message>
    <message>
        <source>cannot listen on {}: {}</source>
        <translation>auf {} kann nicht gehorcht werden: {}</translation>
    </message>
    <message>
        <source>give an address of this machine and a free port, or port 0</source>
        <translation>geben Sie eine Adresse dieses Rechners und einen freien Port an, oder Port 0</translation>
    </message>
    <message>
        <source>check that the board is on and no other program uses it, then connect again</source>
        <translation>prüfen Sie, dass das Steuergerät eingeschaltet ist und kein anderes Programm es verwendet, dann verbinden Sie erneut</translation>
    </message>
    <message>
        <source>the board takes no more commands</source>
        <translation>das Steuergerät nimmt keine Befehle mehr an</translation>
    </message>
    <message>
        <source>the connection is closed</source>
        <translation>die Verbindung ist geschlossen</translation>
    </message>
    <message>
        <source>the board closed the connection (another program may have taken it)</source>
        <translation>das Steuergerät hat die Verbindung geschlossen (vielleicht hat ein anderes Programm sie übernommen)</translation>
    </message>
    <message>
        <source>{} octets are more than the allowed {}</source>
        <translation>{} Byte sind mehr als die erlaubten {}</translation>
    </message>
    <message>
        <source>the board&apos;s description, octet {}: {}</source>
        <translation>die Beschreibung des Steuergeräts, Byte {}: {}</translation>
    </message>
    <message>
        <source>update the board&apos;s firmware or report the description to its maker</source>
        <translation>aktualisieren Sie die Firmware des Steuergeräts, oder melden Sie die Beschreibung dem Hersteller</translation>
    </message>
    <message>
        <source>a comment does not end</source>
        <translation>ein Kommentar endet nicht</translation>
    </message>
    <message>
        <source>a text is too long</source>
        <translation>ein Text ist zu lang</translation>
    </message>
    <message>
        <source>a text does not end</source>
        <translation>ein Text endet nicht</translation>
    </message>
    <message>
        <source>a word is too long</source>
        <translation>ein Wort ist zu lang</translation>
    </message>
    <message>
        <source>the name of a block is missing</source>
        <translation>der Name eines Blocks fehlt</translation>
    </message>
    <message>
        <source>{} is missing</source>
        <translation>{} fehlt</translation>
    </message>
    <message>
        <source>{} is missing (a text in quotes)</source>
        <translation>{} fehlt (ein Text in Anführungszeichen)</translation>
    </message>
    <message>
        <source>{}: &apos;{}&apos; is not a number</source>
        <translation>{}: „{}“ ist keine Zahl</translation>
    </message>
    <message>
        <source>{}: {} is not a whole number from 0 to {}</source>
        <translation>{}: {} ist keine ganze Zahl von 0 bis {}</translation>
    </message>
    <message>
        <source>block {} does not end</source>
        <translation>der Block {} endet nicht</translation>
    </message>
    <message>
        <source>blocks are nested deeper than {}</source>
        <translation>Blöcke sind tiefer als {} verschachtelt</translation>
    </message>
    <message>
        <source>/end {} where /end {} is due</source>
        <translation>/end {}, wo /end {} fällig ist</translation>
    </message>
    <message>
        <source>its type &apos;{}&apos; is not known</source>
        <translation>sein Typ „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>its conversion &apos;{}&apos; is {}</source>
        <translation>seine Umrechnung „{}“ ist {}</translation>
    </message>
    <message>
        <source>not of a supported kind</source>
        <translation>von keiner unterstützten Art</translation>
    </message>
    <message>
        <source>its lower limit is above the upper one; the type&apos;s limits are used</source>
        <translation>seine untere Grenze liegt über der oberen; es gelten die Grenzen des Typs</translation>
    </message>
    <message>
        <source>&apos;{}&apos; (octet {} of the description): {}</source>
        <translation>„{}“ (Byte {} der Beschreibung): {}</translation>
    </message>
    <message>
        <source>this board cannot capture by itself</source>
        <translation>dieses Steuergerät kann nicht selbst erfassen</translation>
    </message>
    <message>
        <source>record a stream instead</source>
        <translation>zeichnen Sie stattdessen einen Datenstrom auf</translation>
    </message>
    <message>
        <source>signal {} has {} octets; the board samples values of up to {} octets in steps of {}</source>
        <translation>Signal {} hat {} Byte; das Steuergerät tastet Werte bis {} Byte in Schritten von {} ab</translation>
    </message>
    <message>
        <source>leave this signal out</source>
        <translation>lassen Sie dieses Signal weg</translation>
    </message>
    <message>
        <source>{} signals do not fit into one sample of this board</source>
        <translation>{} Signale passen nicht in einen Abtastwert dieses Steuergeräts</translation>
    </message>
    <message>
        <source>ask for fewer signals</source>
        <translation>verlangen Sie weniger Signale</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;</source>
        <translation>„{}“ kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>make room or make the folder writable</source>
        <translation>schaffen Sie Platz, oder machen Sie den Ordner beschreibbar</translation>
    </message>
    <message>
        <source>cannot rename &apos;{}&apos;</source>
        <translation>„{}“ kann nicht umbenannt werden</translation>
    </message>
    <message>
        <source>make the folder writable</source>
        <translation>machen Sie den Ordner beschreibbar</translation>
    </message>
    <message>
        <source>the command queue was cleared</source>
        <translation>die Befehlswarteschlange wurde geleert</translation>
    </message>
    <message>
        <source>the board is busy</source>
        <translation>das Steuergerät ist beschäftigt</translation>
    </message>
    <message>
        <source>not possible while samples are streaming</source>
        <translation>nicht möglich, solange Abtastwerte strömen</translation>
    </message>
    <message>
        <source>not possible while the board is being programmed</source>
        <translation>nicht möglich, solange das Steuergerät programmiert wird</translation>
    </message>
    <message>
        <source>the board does not know the command</source>
        <translation>das Steuergerät kennt den Befehl nicht</translation>
    </message>
    <message>
        <source>the board found the command malformed</source>
        <translation>das Steuergerät hält den Befehl für fehlerhaft</translation>
    </message>
    <message>
        <source>the value is out of range</source>
        <translation>der Wert ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the memory is write protected</source>
        <translation>der Speicher ist schreibgeschützt</translation>
    </message>
    <message>
        <source>access is denied</source>
        <translation>der Zugriff ist verweigert</translation>
    </message>
    <message>
        <source>access is locked</source>
        <translation>der Zugriff ist gesperrt</translation>
    </message>
    <message>
        <source>the page does not exist</source>
        <translation>die Seite gibt es nicht</translation>
    </message>
    <message>
        <source>the mode does not exist</source>
        <translation>die Betriebsart gibt es nicht</translation>
    </message>
    <message>
        <source>the segment does not exist</source>
        <translation>das Segment gibt es nicht</translation>
    </message>
    <message>
        <source>the commands came in the wrong order</source>
        <translation>die Befehle kamen in falscher Reihenfolge</translation>
    </message>
    <message>
        <source>the list of samples is not valid</source>
        <translation>die Abtastliste ist nicht gültig</translation>
    </message>
    <message>
        <source>the board has no memory left</source>
        <translation>das Steuergerät hat keinen Speicher mehr</translation>
    </message>
    <message>
        <source>the board refuses</source>
        <translation>das Steuergerät lehnt ab</translation>
    </message>
    <message>
        <source>verification failed</source>
        <translation>die Prüfung ist gescheitert</translation>
    </message>
    <message>
        <source>the resource is not accessible now</source>
        <translation>die Ressource ist jetzt nicht zugänglich</translation>
    </message>
    <message>
        <source>the answer to {} has {} octets ({}), {} are needed</source>
        <translation>die Antwort auf {} hat {} Byte ({}), {} sind nötig</translation>
    </message>
    <message>
        <source>update the board&apos;s firmware or check the line</source>
        <translation>aktualisieren Sie die Firmware des Steuergeräts, oder prüfen Sie die Leitung</translation>
    </message>
    <message>
        <source>command {}</source>
        <translation>Befehl {}</translation>
    </message>
    <message>
        <source>unknown error {}</source>
        <translation>unbekannter Fehler {}</translation>
    </message>
    <message>
        <source>the board counts addresses in words, not octets</source>
        <translation>das Steuergerät zählt Adressen in Wörtern, nicht in Byte</translation>
    </message>
    <message>
        <source>only octet granularity is supported</source>
        <translation>nur byteweise Adressierung wird unterstützt</translation>
    </message>
    <message>
        <source>the board announces packets of {} and {} octets, at least 8 are needed</source>
        <translation>das Steuergerät kündigt Pakete von {} und {} Byte an, mindestens 8 sind nötig</translation>
    </message>
    <message>
        <source>this is not a board of a protocol known here</source>
        <translation>dies ist kein Steuergerät eines hier bekannten Protokolls</translation>
    </message>
    <message>
        <source>the answer to GET_ID promises {} octets and holds {}</source>
        <translation>die Antwort auf GET_ID verspricht {} Byte und enthält {}</translation>
    </message>
    <message>
        <source>the sampling resolution makes no sense ({})</source>
        <translation>die Abtastauflösung ergibt keinen Sinn ({})</translation>
    </message>
    <message>
        <source>update the board&apos;s firmware</source>
        <translation>aktualisieren Sie die Firmware des Steuergeräts</translation>
    </message>
    <message>
        <source>time unit {} does not exist</source>
        <translation>die Zeiteinheit {} gibt es nicht</translation>
    </message>
    <message>
        <source>the board runs on page {} of a segment of {} octets</source>
        <translation>das Steuergerät läuft auf Seite {} eines Segments von {} Byte</translation>
    </message>
    <message>
        <source>only pages 0 and 1 are known here; update the board&apos;s firmware</source>
        <translation>nur die Seiten 0 und 1 sind hier bekannt; aktualisieren Sie die Firmware des Steuergeräts</translation>
    </message>
    <message>
        <source>the board does not free its idle parameter page</source>
        <translation>das Steuergerät gibt seine ruhende Parameterseite nicht frei</translation>
    </message>
    <message>
        <source>check that the board&apos;s control loop runs; the old values stay</source>
        <translation>prüfen Sie, dass der Regelkreis des Steuergeräts läuft; die alten Werte bleiben</translation>
    </message>
    <message>
        <source>the board did not take the new set of parameters</source>
        <translation>das Steuergerät hat den neuen Parametersatz nicht übernommen</translation>
    </message>
    <message>
        <source>check the board&apos;s state; the old values stay</source>
        <translation>prüfen Sie den Zustand des Steuergeräts; die alten Werte bleiben</translation>
    </message>
    <message>
        <source>the board keeps other values than those sent</source>
        <translation>das Steuergerät behält andere Werte als die gesendeten</translation>
    </message>
    <message>
        <source>the old values stay; check the limits of the board</source>
        <translation>die alten Werte bleiben; prüfen Sie die Grenzwerte des Steuergeräts</translation>
    </message>
    <message>
        <source>the nearest possible rates are {} Hz and {} Hz</source>
        <translation>die nächsten möglichen Raten sind {} Hz und {} Hz</translation>
    </message>
    <message>
        <source>the nearest possible rate is {} Hz</source>
        <translation>die nächste mögliche Rate ist {} Hz</translation>
    </message>
    <message>
        <source>these signals have no periodic event</source>
        <translation>diese Signale haben kein periodisches Ereignis</translation>
    </message>
    <message>
        <source>the board samples &apos;{}&apos; ({}) at another event than &apos;{}&apos; ({})</source>
        <translation>das Steuergerät tastet „{}“ ({}) mit einem anderen Ereignis ab als „{}“ ({})</translation>
    </message>
    <message>
        <source>stream signals of one event together, the others in a stream of their own</source>
        <translation>lesen Sie Signale desselben Ereignisses zusammen, die anderen in einem eigenen Datenstrom</translation>
    </message>
    <message>
        <source>the device has no signal &apos;{}&apos;</source>
        <translation>das Gerät hat kein Signal „{}“</translation>
    </message>
    <message>
        <source>list the signals with: halbench describe DEVICE</source>
        <translation>die Signale listet: halbench describe GERÄT</translation>
    </message>
    <message>
        <source>a stream needs at least one signal</source>
        <translation>ein Datenstrom braucht mindestens ein Signal</translation>
    </message>
    <message>
        <source>name a signal</source>
        <translation>nennen Sie ein Signal</translation>
    </message>
    <message>
        <source>the device cannot send these signals at {} Hz</source>
        <translation>das Gerät kann diese Signale nicht mit {} Hz senden</translation>
    </message>
    <message>
        <source>the board&apos;s parameters are locked</source>
        <translation>die Parameter des Steuergeräts sind gesperrt</translation>
    </message>
    <message>
        <source>description of &apos;{}&apos; taken from the cache</source>
        <translation>Beschreibung von „{}“ aus dem Zwischenspeicher genommen</translation>
    </message>
    <message>
        <source>description read from the board, {} octets</source>
        <translation>Beschreibung vom Steuergerät gelesen, {} Byte</translation>
    </message>
    <message>
        <source>the description is not kept: {}</source>
        <translation>die Beschreibung wird nicht behalten: {}</translation>
    </message>
    <message>
        <source>the board could not send all samples in time</source>
        <translation>das Steuergerät konnte nicht alle Abtastwerte rechtzeitig senden</translation>
    </message>
    <message>
        <source>the board stopped</source>
        <translation>das Steuergerät hat gestoppt</translation>
    </message>
    <message>
        <source>the board stopped the actuator: {}</source>
        <translation>das Steuergerät hat den Aktor gestoppt: {}</translation>
    </message>
    <message>
        <source>this board has no &apos;{}&apos; and cannot be armed from here</source>
        <translation>dieses Steuergerät hat kein „{}“ und kann von hier nicht freigegeben werden</translation>
    </message>
    <message>
        <source>use the maker&apos;s own program to arm it</source>
        <translation>verwenden Sie zum Freigeben das Programm des Herstellers</translation>
    </message>
    <message>
        <source>the board cannot be armed: {}</source>
        <translation>das Steuergerät kann nicht freigegeben werden: {}</translation>
    </message>
    <message>
        <source>find the cause, then clear the stop</source>
        <translation>finden Sie die Ursache, dann heben Sie den Stopp auf</translation>
    </message>
    <message>
        <source>the board does not {}</source>
        <translation>das Steuergerät führt „{}“ nicht aus</translation>
    </message>
    <message>
        <source>use the stop at the actuator and check the board</source>
        <translation>verwenden Sie den Halt am Aktor und prüfen Sie das Steuergerät</translation>
    </message>
    <message>
        <source>the board keeps its stop: {}</source>
        <translation>das Steuergerät behält seinen Stopp: {}</translation>
    </message>
    <message>
        <source>remove the cause first</source>
        <translation>beseitigen Sie zuerst die Ursache</translation>
    </message>
    <message>
        <source>this device cannot stream signals</source>
        <translation>dieses Gerät kann keine Signale als Datenstrom senden</translation>
    </message>
    <message>
        <source>read single values instead</source>
        <translation>lesen Sie stattdessen einzelne Werte</translation>
    </message>
    <message>
        <source>link: {} packets, {} lost, {} damaged, {} commands repeated, round trip {} ms, at worst {} ms</source>
        <translation>Verbindung: {} Pakete, {} verloren, {} beschädigt, {} Befehle wiederholt, Umlaufzeit {} ms, höchstens {} ms</translation>
    </message>
    <message>
        <source>, the board&apos;s clock gains {} +- {} ppm</source>
        <translation>, die Uhr des Steuergeräts geht {} ± {} ppm vor</translation>
    </message>
    <message>
        <source>{} sends no samples any more</source>
        <translation>{} sendet keine Abtastwerte mehr</translation>
    </message>
    <message>
        <source>the board or another program ended the stream; connect again</source>
        <translation>das Steuergerät oder ein anderes Programm hat den Datenstrom beendet; verbinden Sie erneut</translation>
    </message>
    <message>
        <source>list the names with: halbench describe DEVICE</source>
        <translation>die Namen listet: halbench describe GERÄT</translation>
    </message>
    <message>
        <source>the device has no parameter &apos;{}&apos;</source>
        <translation>das Gerät hat keinen Parameter „{}“</translation>
    </message>
    <message>
        <source>the board keeps another value of &apos;{}&apos; than the one sent</source>
        <translation>das Steuergerät behält für „{}“ einen anderen Wert als den gesendeten</translation>
    </message>
    <message>
        <source>the old values stay; give values inside the board&apos;s limits</source>
        <translation>die alten Werte bleiben; geben Sie Werte innerhalb der Grenzen des Steuergeräts an</translation>
    </message>
    <message>
        <source>this board cannot change a set at once: values change one by one</source>
        <translation>dieses Steuergerät kann einen Satz nicht auf einmal ändern: die Werte ändern sich einzeln</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos;: {}</source>
        <translation>Parameter „{}“: {}</translation>
    </message>
    <message>
        <source>the board keeps &apos;{}&apos; = {} {} instead of {}</source>
        <translation>das Steuergerät behält „{}“ = {} {} statt {}</translation>
    </message>
    <message>
        <source>check the board&apos;s state and limits</source>
        <translation>prüfen Sie Zustand und Grenzwerte des Steuergeräts</translation>
    </message>
    <message>
        <source>check cable, power and address, then connect again</source>
        <translation>prüfen Sie Kabel, Stromversorgung und Adresse, dann verbinden Sie erneut</translation>
    </message>
    <message>
        <source>{} does not answer {}</source>
        <translation>{} antwortet nicht auf {}</translation>
    </message>
    <message>
        <source>the board refused {}: {}</source>
        <translation>das Steuergerät hat {} abgelehnt: {}</translation>
    </message>
    <message>
        <source>check the value and the board&apos;s state</source>
        <translation>prüfen Sie den Wert und den Zustand des Steuergeräts</translation>
    </message>
    <message>
        <source>{} ended the session (its watchdog ran out or another program connected)</source>
        <translation>{} hat die Sitzung beendet (die Überwachungszeit lief ab, oder ein anderes Programm hat verbunden)</translation>
    </message>
    <message>
        <source>make sure that no other program uses the board, then connect again</source>
        <translation>stellen Sie sicher, dass kein anderes Programm das Steuergerät verwendet, dann verbinden Sie erneut</translation>
    </message>
    <message>
        <source>{} does not answer any more</source>
        <translation>{} antwortet nicht mehr</translation>
    </message>
    <message>
        <source>the board did not store its parameters within {} s</source>
        <translation>das Steuergerät hat seine Parameter nicht innerhalb von {} s gespeichert</translation>
    </message>
    <message>
        <source>try again, then read the values back</source>
        <translation>versuchen Sie es erneut, dann lesen Sie die Werte zurück</translation>
    </message>
    <message>
        <source>the board holds no description of itself</source>
        <translation>das Steuergerät enthält keine Beschreibung seiner selbst</translation>
    </message>
    <message>
        <source>the board&apos;s description has {} octets</source>
        <translation>die Beschreibung des Steuergeräts hat {} Byte</translation>
    </message>
    <message>
        <source>the board needed more than {} s for its description</source>
        <translation>das Steuergerät brauchte mehr als {} s für seine Beschreibung</translation>
    </message>
    <message>
        <source>use a faster connection</source>
        <translation>verwenden Sie eine schnellere Verbindung</translation>
    </message>
    <message>
        <source>Every amplifier part must be positive and finite.</source>
        <translation>Jedes Bauteil des Verstärkers muss positiv und endlich sein.</translation>
    </message>
    <message>
        <source>Check resistors, capacitors and the coil&apos;s resistance and inductance.</source>
        <translation>Prüfen Sie Widerstände, Kondensatoren und Widerstand und Induktivität der Spule.</translation>
    </message>
    <message>
        <source>The decoded angle jumped by more than 90 degrees between two samples.</source>
        <translation>Der dekodierte Winkel sprang zwischen zwei Abtastwerten um mehr als 90 Grad.</translation>
    </message>
    <message>
        <source>The direction of such a jump is a guess; check the sensors or turn slower.</source>
        <translation>Die Richtung eines solchen Sprungs ist geraten; prüfen Sie die Sensoren, oder drehen Sie langsamer.</translation>
    </message>
    <message>
        <source>Allowed: {} to {}{}{}{}. Known keys: {}.</source>
        <translation>Erlaubt: {} bis {}{}{}{}. Bekannte Schlüssel: {}.</translation>
    </message>
    <message>
        <source>{} is not a finite number</source>
        <translation>{} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>{} = {} is out of range</source>
        <translation>{} = {} ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the planar positioner has no parameter &apos;{}&apos;</source>
        <translation>der Planarpositionierer hat keinen Parameter „{}“</translation>
    </message>
    <message>
        <source>a coil of {} mm width leaves no window within half a pitch of {} mm</source>
        <translation>eine Spule von {} mm Breite lässt kein Fenster innerhalb eines halben Rasters von {} mm</translation>
    </message>
    <message>
        <source>Make coil_width_mm smaller than {} mm.</source>
        <translation>Wählen Sie coil_width_mm kleiner als {} mm.</translation>
    </message>
    <message>
        <source>the start pose lies beyond the stops at {} mm and {} mrad</source>
        <translation>die Startlage liegt außerhalb der Anschläge bei {} mm und {} mrad</translation>
    </message>
    <message>
        <source>Keep x0_mm and y0_mm within {} mm, phi0_mrad within {} mrad.</source>
        <translation>Halten Sie x0_mm und y0_mm innerhalb von {} mm, phi0_mrad innerhalb von {} mrad.</translation>
    </message>
    <message>
        <source>the motor has no parameter &apos;{}&apos;</source>
        <translation>der Motor hat keinen Parameter „{}“</translation>
    </message>
    <message>
        <source>Known keys: {}.</source>
        <translation>Bekannte Schlüssel: {}.</translation>
    </message>
    <message>
        <source>A Hall sensor setting is not a finite number.</source>
        <translation>Eine Einstellung eines Hall-Sensors ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>A Hall sensor needs a positive sensitivity, noise of at least zero and a lower clip voltage below the upper one.</source>
        <translation>Ein Hall-Sensor braucht eine positive Empfindlichkeit, ein Rauschen von mindestens null und eine untere Begrenzungsspannung unter der oberen.</translation>
    </message>
    <message>
        <source>A field harmonic needs an order of at least 1 and finite amplitudes.</source>
        <translation>Eine Feldoberschwingung braucht eine Ordnung von mindestens 1 und endliche Amplituden.</translation>
    </message>
    <message>
        <source>A constant belongs into the offset.</source>
        <translation>Eine Konstante gehört in den Offset.</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>wahr oder falsch</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>eine Tabelle</translation>
    </message>
    <message>
        <source>a date or time</source>
        <translation>Datum oder Uhrzeit</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>ein Wert</translation>
    </message>
    <message>
        <source>{}: is not PATH=VALUE</source>
        <translation>{}: ist nicht PFAD=WERT</translation>
    </message>
    <message>
        <source>write step.sweep.given.J=6e-4</source>
        <translation>schreiben Sie step.sweep.given.J=6e-4</translation>
    </message>
    <message>
        <source>{}: there is no such step</source>
        <translation>{}: diesen Schritt gibt es nicht</translation>
    </message>
    <message>
        <source>write step.NAME.KEY=VALUE with the name of a step of the file</source>
        <translation>schreiben Sie step.NAME.SCHLÜSSEL=WERT mit dem Namen eines Schritts der Datei</translation>
    </message>
    <message>
        <source>{}:{}:{}: not valid JSON: {}</source>
        <translation>{}:{}:{}: kein gültiges JSON: {}</translation>
    </message>
    <message>
        <source>correct the file or write it again with --out</source>
        <translation>berichtigen Sie die Datei oder schreiben Sie sie neu mit --out</translation>
    </message>
    <message>
        <source>the result holds a value that is not a finite number at &apos;{}&apos;</source>
        <translation>das Ergebnis enthält bei „{}“ einen Wert, der keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>report this with the command line that led to it</source>
        <translation>melden Sie dies mit dem Befehl, der dazu führte</translation>
    </message>
    <message>
        <source>is &quot;{}&quot;, this version reads &quot;{}&quot;</source>
        <translation>ist „{}“, diese Version liest „{}“</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is &quot;{}&quot;, not &quot;{}&quot;</source>
        <translation>ist „{}“, nicht „{}“</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to {}</source>
        <translation>muss eine ganze Zahl von 0 bis {} sein</translation>
    </message>
    <message>
        <source>write the file again with &apos;halbench {} --out&apos;</source>
        <translation>schreiben Sie die Datei neu mit „halbench {} --out“</translation>
    </message>
    <message>
        <source>must be a list of lists of numbers</source>
        <translation>muss eine Liste von Zahlenlisten sein</translation>
    </message>
    <message>
        <source>must hold finite numbers</source>
        <translation>muss endliche Zahlen enthalten</translation>
    </message>
    <message>
        <source>needs as many rows as names</source>
        <translation>braucht so viele Zeilen wie Namen</translation>
    </message>
    <message>
        <source>must be square</source>
        <translation>muss quadratisch sein</translation>
    </message>
    <message>
        <source>{}: this estimate was refused</source>
        <translation>{}: diese Schätzung wurde verweigert</translation>
    </message>
    <message>
        <source>see its findings, then identify again</source>
        <translation>lesen Sie die Befunde, dann identifizieren Sie neu</translation>
    </message>
    <message>
        <source>needs a value and the two ends of its interval</source>
        <translation>braucht einen Wert und die beiden Enden seines Intervalls</translation>
    </message>
    <message>
        <source>{}: cannot write: {}</source>
        <translation>{}: kann nicht geschrieben werden: {}</translation>
    </message>
    <message>
        <source>free space on the disk</source>
        <translation>schaffen Sie Platz auf dem Datenträger</translation>
    </message>
    <message>
        <source>choose another path or change its permissions</source>
        <translation>wählen Sie einen anderen Pfad oder ändern Sie seine Rechte</translation>
    </message>
    <message>
        <source>{}: is a folder</source>
        <translation>{}: ist ein Ordner</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>nennen Sie eine Datei</translation>
    </message>
    <message>
        <source>{}: cannot read: {}</source>
        <translation>{}: kann nicht gelesen werden: {}</translation>
    </message>
    <message>
        <source>{}: larger than 256 MB</source>
        <translation>{}: größer als 256 MB</translation>
    </message>
    <message>
        <source>give a smaller file</source>
        <translation>geben Sie eine kleinere Datei an</translation>
    </message>
    <message>
        <source>there is no preset &apos;{}&apos; for a device of model &apos;{}&apos;</source>
        <translation>für ein Gerät des Modells „{1}“ gibt es keinen Parametersatz „{0}“</translation>
    </message>
    <message>
        <source>htm has {}</source>
        <translation>htm hat {}</translation>
    </message>
    <message>
        <source>compare with resources/presets/htm/published.json</source>
        <translation>vergleichen Sie mit resources/presets/htm/published.json</translation>
    </message>
    <message>
        <source>must be &quot;halbench.preset/1&quot;</source>
        <translation>muss „halbench.preset/1“ sein</translation>
    </message>
    <message>
        <source>must be an object of numbers</source>
        <translation>muss ein Objekt aus Zahlen sein</translation>
    </message>
    <message>
        <source>{}:{}:{}: not valid TOML: {}</source>
        <translation>{}:{}:{}: kein gültiges TOML: {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a text</source>
        <translation>„{}“ muss ein Text sein</translation>
    </message>
    <message>
        <source>&apos;layout&apos; must be a table</source>
        <translation>„layout“ muss eine Tabelle sein</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a list of tables, [[{}]]</source>
        <translation>„{}“ muss eine Liste von Tabellen sein, [[{}]]</translation>
    </message>
    <message>
        <source>the file is left as it is; open another project or mend this line</source>
        <translation>die Datei bleibt, wie sie ist; öffnen Sie ein anderes Projekt oder berichtigen Sie diese Zeile</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a [[{}]] has name and document</source>
        <translation>unbekannter Schlüssel „{}“; ein [[{}]] hat name und document</translation>
    </message>
    <message>
        <source>{}: is a &apos;{}&apos;, made by a newer version</source>
        <translation>{}: ist ein „{}“ einer neueren Version</translation>
    </message>
    <message>
        <source>this version reads {}; the file is left as it is</source>
        <translation>diese Version liest {}; die Datei bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>{}: is not a Halbench project</source>
        <translation>{}: ist kein Halbench-Projekt</translation>
    </message>
    <message>
        <source>a project begins with schema = &quot;{}&quot;</source>
        <translation>ein Projekt beginnt mit schema = &quot;{}&quot;</translation>
    </message>
    <message>
        <source>choose another preset</source>
        <translation>wählen Sie einen anderen Parametersatz</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is too large for a preset</source>
        <translation>„{}“ ist zu groß für einen Parametersatz</translation>
    </message>
    <message>
        <source>choose a preset file</source>
        <translation>wählen Sie eine Parametersatzdatei</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was written by a newer Halbench ({})</source>
        <translation>„{}“ wurde von einem neueren Halbench geschrieben ({})</translation>
    </message>
    <message>
        <source>open it there, or install that version</source>
        <translation>öffnen Sie sie dort, oder installieren Sie jene Version</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is for a device of model &apos;{}&apos;</source>
        <translation>„{}“ ist für ein Gerät des Modells „{}“</translation>
    </message>
    <message>
        <source>this device is of model &apos;{}&apos;</source>
        <translation>dieses Gerät ist vom Modell „{}“</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be the name of a preset</source>
        <translation>„{}“ kann kein Name eines Parametersatzes sein</translation>
    </message>
    <message>
        <source>use letters, digits, spaces, points and hyphens</source>
        <translation>verwenden Sie Buchstaben, Ziffern, Leerzeichen, Punkte und Bindestriche</translation>
    </message>
    <message>
        <source>check the folder and the space on the disk</source>
        <translation>prüfen Sie den Ordner und den Platz auf dem Datenträger</translation>
    </message>
    <message>
        <source>choose another folder or name</source>
        <translation>wählen Sie einen anderen Ordner oder Namen</translation>
    </message>
    <message>
        <source>there is no picture to save</source>
        <translation>es gibt kein Bild zu sichern</translation>
    </message>
    <message>
        <source>K_P = {}, K_I = {}, K_D = {} is no position loop</source>
        <translation>K_P = {}, K_I = {}, K_D = {} ergeben keinen Lageregelkreis</translation>
    </message>
    <message>
        <source>K_P must be positive, K_I and K_D not negative</source>
        <translation>K_P muss positiv sein, K_I und K_D nicht negativ</translation>
    </message>
    <message>
        <source>a current limit of {} A is not possible</source>
        <translation>eine Stromgrenze von {} A ist nicht möglich</translation>
    </message>
    <message>
        <source>the stray field of the coils is not described by finite numbers</source>
        <translation>das Streufeld der Spulen ist nicht durch endliche Zahlen beschrieben</translation>
    </message>
    <message>
        <source>the sampled loop is unstable: pole radius {}</source>
        <translation>der abgetastete Regelkreis ist instabil: Polradius {}</translation>
    </message>
    <message>
        <source>only friction and the current limit bound it, and no common factor on these gains makes it stable: change their ratio or the filters, or use method recommended</source>
        <translation>nur Reibung und Stromgrenze beschränken die Bewegung, und kein gemeinsamer Faktor auf diese Verstärkungen macht den Kreis stabil: ändern Sie ihr Verhältnis oder die Filter, oder verwenden Sie das Verfahren recommended</translation>
    </message>
    <message>
        <source>only friction and the current limit bound it; below {} times these gains it is stable: lower K_P, or use method recommended</source>
        <translation>nur Reibung und Stromgrenze beschränken die Bewegung; unterhalb des {}-Fachen dieser Verstärkungen ist der Kreis stabil: verringern Sie K_P, oder verwenden Sie das Verfahren recommended</translation>
    </message>
    <message>
        <source>only friction and the current limit bound it; above {} times these gains it is stable: raise them, or use method recommended</source>
        <translation>nur Reibung und Stromgrenze beschränken die Bewegung; oberhalb des {}-Fachen dieser Verstärkungen ist der Kreis stabil: erhöhen Sie sie, oder verwenden Sie das Verfahren recommended</translation>
    </message>
    <message>
        <source>K_P = {} A/rad is {} times the limit of {} A/rad at this sampling and delay</source>
        <translation>K_P = {} A/rad ist das {}-Fache der Grenze von {} A/rad bei dieser Abtastung und Totzeit</translation>
    </message>
    <message>
        <source>the rotor rests and makes small steps at best; large steps end in a limit cycle</source>
        <translation>der Rotor ruht und macht allenfalls kleine Sprünge; große Sprünge enden in einem Grenzzyklus</translation>
    </message>
    <message>
        <source>the loop is nearly undamped (zeta = {} at {} rad/s): only friction damps it</source>
        <translation>der Regelkreis ist fast ungedämpft (zeta = {} bei {} rad/s): nur Reibung dämpft ihn</translation>
    </message>
    <message>
        <source>a PI loop cannot do better on this motor; derivative action can: method recommended</source>
        <translation>besser kann es ein PI-Regler an diesem Motor nicht; ein D-Anteil kann es: Verfahren recommended</translation>
    </message>
    <message>
        <source>small margins: {} deg of phase, a factor {} of gain</source>
        <translation>kleine Reserven: {} Grad Phase, Faktor {} Verstärkung</translation>
    </message>
    <message>
        <source>the usual least are 30 deg and a factor 2</source>
        <translation>üblich sind mindestens 30 Grad und Faktor 2</translation>
    </message>
    <message>
        <source>friction holds the rotor within +-{} deg of the reference</source>
        <translation>Reibung hält den Rotor innerhalb von ±{} Grad um die Führungsgröße fest</translation>
    </message>
    <message>
        <source>only the integral removes the rest, slowly; the micro-step assist or a larger K_P narrows the band</source>
        <translation>nur der I-Anteil beseitigt den Rest, langsam; die Mikroschritthilfe oder ein größeres K_P verengt das Band</translation>
    </message>
    <message>
        <source>the micro-step assist or a larger K_P narrows the band</source>
        <translation>die Mikroschritthilfe oder ein größeres K_P verengt das Band</translation>
    </message>
    <message>
        <source>the stray field of the coils is not compensated and feeds the current back into the angle: this gain can make it alternate every sample</source>
        <translation>das Streufeld der Spulen ist nicht kompensiert und führt den Strom auf den Winkel zurück: mit dieser Verstärkung kann er bei jedem Abtastwert wechseln</translation>
    </message>
    <message>
        <source>switch the compensation on (stray.enabled)</source>
        <translation>schalten Sie die Kompensation ein (stray.enabled)</translation>
    </message>
    <message>
        <source>this gain needs the stray coefficient to better than {} %, and its error is not known</source>
        <translation>diese Verstärkung braucht den Streufeldkoeffizienten genauer als {} %, und sein Fehler ist nicht bekannt</translation>
    </message>
    <message>
        <source>calibrate the stray field first</source>
        <translation>kalibrieren Sie zuerst das Streufeld</translation>
    </message>
    <message>
        <source>the stray coefficient is known to {} %, this gain needs better than {} %</source>
        <translation>der Streufeldkoeffizient ist auf {} % bekannt, diese Verstärkung braucht ihn genauer als {} %</translation>
    </message>
    <message>
        <source>calibrate the stray field again, or lower the gains</source>
        <translation>kalibrieren Sie das Streufeld neu, oder verringern Sie die Reglerparameter</translation>
    </message>
    <message>
        <source>steps above {} deg reach the current limit of {} A; with it and with friction a step of {} deg overshoots by {} %</source>
        <translation>Sprünge über {} Grad erreichen die Stromgrenze von {} A; mit ihr und mit Reibung überschwingt ein Sprung von {} Grad um {} %</translation>
    </message>
    <message>
        <source>lead large moves along a ramp, or choose a slower loop</source>
        <translation>führen Sie große Bewegungen über eine Rampe, oder wählen Sie einen langsameren Regelkreis</translation>
    </message>
    <message>
        <source>`halbench describe` lists the parameters.</source>
        <translation>„halbench describe“ listet die Parameter.</translation>
    </message>
    <message>
        <source>{} reads {} after writing {}</source>
        <translation>{} liest sich als {}, nachdem {} geschrieben wurde</translation>
    </message>
    <message>
        <source>The old values run again; check the device&apos;s limits.</source>
        <translation>Die alten Werte gelten wieder; prüfen Sie die Grenzwerte des Geräts.</translation>
    </message>
    <message>
        <source>a {} has no prediction to verify against</source>
        <translation>für „{}“ gibt es keine Vorhersage, an der nachgewiesen werden kann</translation>
    </message>
    <message>
        <source>Verify with a step, ramp, sine or staircase.</source>
        <translation>Weisen Sie mit einem Sprung, einer Rampe, einem Sinus oder einer Treppe nach.</translation>
    </message>
    <message>
        <source>{} was {} {}, the prediction allows {} {}</source>
        <translation>{} war {} {}, die Vorhersage erlaubt {} {}</translation>
    </message>
    <message>
        <source>The old values run again. Identify the motor anew, or choose calmer gains.</source>
        <translation>Die alten Werte gelten wieder. Identifizieren Sie den Motor neu, oder wählen Sie ruhigere Reglerparameter.</translation>
    </message>
    <message>
        <source>final error</source>
        <translation>bleibender Fehler</translation>
    </message>
    <message>
        <source>rms error</source>
        <translation>Fehler (Effektivwert)</translation>
    </message>
    <message>
        <source>the readings lie {} % of the amplitude away from their ellipse</source>
        <translation>die Messwerte liegen um {} % der Amplitude neben ihrer Ellipse</translation>
    </message>
    <message>
        <source>look for saturated sensors or a loose magnet</source>
        <translation>achten Sie auf übersteuerte Sensoren oder einen losen Magneten</translation>
    </message>
    <message>
        <source>spins slowly for the Hall sensors</source>
        <translation>dreht langsam für die Hall-Sensoren</translation>
    </message>
    <message>
        <source>use a spin current above the breakaway current</source>
        <translation>verwenden Sie einen Drehstrom über dem Losbrechstrom</translation>
    </message>
    <message>
        <source>the angle error of {} degrees rms that the ellipse leaves is not known well enough ({} degrees: ripple of the speed and scatter)</source>
        <translation>der Winkelfehler von {} Grad (Effektivwert), den die Ellipse übrig lässt, ist nicht genau genug bekannt ({} Grad: Welligkeit der Drehzahl und Streuung)</translation>
    </message>
    <message>
        <source>the ellipse alone is as good</source>
        <translation>die Ellipse allein ist ebenso gut</translation>
    </message>
    <message>
        <source>the rotor did not turn fast and long enough to show the angle error that the ellipse leaves</source>
        <translation>der Rotor drehte nicht schnell und lange genug, um den Winkelfehler zu zeigen, den die Ellipse übrig lässt</translation>
    </message>
    <message>
        <source>allow a higher current or speed</source>
        <translation>erlauben Sie mehr Strom oder eine höhere Drehzahl</translation>
    </message>
    <message>
        <source>spins fast for the angle error</source>
        <translation>dreht schnell für den Winkelfehler</translation>
    </message>
    <message>
        <source>no calibration was chosen</source>
        <translation>es wurde keine Kalibrierung gewählt</translation>
    </message>
    <message>
        <source>choose hall, stray, static-friction or all</source>
        <translation>wählen Sie hall, stray, static-friction oder all</translation>
    </message>
    <message>
        <source>the currents of a calibration must lie in (0, 4] A</source>
        <translation>die Ströme einer Kalibrierung müssen in (0, 4] A liegen</translation>
    </message>
    <message>
        <source>2 to 50 starts in each direction are possible</source>
        <translation>2 bis 50 Anläufe in jeder Richtung sind möglich</translation>
    </message>
    <message>
        <source>turns to another angle</source>
        <translation>dreht in einen anderen Winkel</translation>
    </message>
    <message>
        <source>d-axis current at rest</source>
        <translation>Strom der d-Achse im Stillstand</translation>
    </message>
    <message>
        <source>ramps the current from rest</source>
        <translation>steigert den Strom aus dem Stillstand</translation>
    </message>
    <message>
        <source>the rotor broke loose in too few of the ramps</source>
        <translation>der Rotor riss sich bei zu wenigen der Rampen los</translation>
    </message>
    <message>
        <source>ramp to a higher current</source>
        <translation>steigern Sie bis zu einem größeren Strom</translation>
    </message>
    <message>
        <source>the rate must be more than zero</source>
        <translation>die Rate muss größer als null sein</translation>
    </message>
    <message>
        <source>Give e.g. --rate 1000.</source>
        <translation>Geben Sie z. B. --rate 1000 an.</translation>
    </message>
    <message>
        <source>a capture at {} Hz is not possible</source>
        <translation>eine Erfassung mit {} Hz ist nicht möglich</translation>
    </message>
    <message>
        <source>the rate must divide that of the loop, {} Hz; the nearest is {} Hz</source>
        <translation>die Rate muss die des Regelkreises, {} Hz, teilen; die nächste ist {} Hz</translation>
    </message>
    <message>
        <source>the share of rows before the trigger lies from 0 to below 1</source>
        <translation>der Anteil der Zeilen vor dem Trigger liegt von 0 bis unter 1</translation>
    </message>
    <message>
        <source>Give e.g. --pre-trigger 0.25.</source>
        <translation>Geben Sie z. B. --pre-trigger 0.25 an.</translation>
    </message>
    <message>
        <source>the wait for the trigger must be more than zero seconds</source>
        <translation>die Wartezeit auf den Trigger muss größer als null Sekunden sein</translation>
    </message>
    <message>
        <source>Give e.g. --wait 10.</source>
        <translation>Geben Sie z. B. --wait 10 an.</translation>
    </message>
    <message>
        <source>a capture takes 1 to {} signals</source>
        <translation>eine Erfassung nimmt 1 bis {} Signale auf</translation>
    </message>
    <message>
        <source>record a stream for more</source>
        <translation>zeichnen Sie für mehr einen Datenstrom auf</translation>
    </message>
    <message>
        <source>`halbench describe` lists the signals.</source>
        <translation>„halbench describe“ listet die Signale.</translation>
    </message>
    <message>
        <source>the signal &apos;{}&apos; is named twice</source>
        <translation>das Signal „{}“ ist zweimal genannt</translation>
    </message>
    <message>
        <source>Name every signal once.</source>
        <translation>nennen Sie jedes Signal einmal.</translation>
    </message>
    <message>
        <source>the trigger did not come within {} s</source>
        <translation>der Trigger kam nicht innerhalb von {} s</translation>
    </message>
    <message>
        <source>wait longer with --wait, or choose another --trigger</source>
        <translation>warten Sie länger mit --wait, oder wählen Sie einen anderen --trigger</translation>
    </message>
    <message>
        <source>waits for the trigger</source>
        <translation>wartet auf den Trigger</translation>
    </message>
    <message>
        <source>the board captured other signals than it was asked for</source>
        <translation>das Steuergerät erfasste andere Signale als verlangt</translation>
    </message>
    <message>
        <source>another program may be using its capture; try again</source>
        <translation>ein anderes Programm verwendet vielleicht seine Erfassung; versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>a captured value is not a number</source>
        <translation>ein erfasster Wert ist keine Zahl</translation>
    </message>
    <message>
        <source>The board or the link delivers damaged values; nothing was kept of them.</source>
        <translation>Das Steuergerät oder die Verbindung liefert beschädigte Werte; nichts davon wurde behalten.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no trigger</source>
        <translation>„{}“ ist kein Trigger</translation>
    </message>
    <message>
        <source>use now, reference, SIGNAL&gt;LEVEL (rising) or SIGNAL&lt;LEVEL (falling)</source>
        <translation>verwenden Sie now, reference, SIGNAL&gt;PEGEL (steigend) oder SIGNAL&lt;PEGEL (fallend)</translation>
    </message>
    <message>
        <source>the level of a trigger is not finite</source>
        <translation>der Pegel eines Triggers ist nicht endlich</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>geben Sie eine Zahl an</translation>
    </message>
    <message>
        <source>a coil is at {} degC and does not cool below {} degC</source>
        <translation>eine Spule hat {} °C und kühlt nicht unter {} °C ab</translation>
    </message>
    <message>
        <source>Cool the motor&apos;s surroundings and try again.</source>
        <translation>Kühlen Sie die Umgebung des Motors und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>waits for the coils to cool: {} degC</source>
        <translation>wartet, bis die Spulen abkühlen: {} °C</translation>
    </message>
    <message>
        <source>a coil temperature is not a number</source>
        <translation>eine Spulentemperatur ist keine Zahl</translation>
    </message>
    <message>
        <source>Nothing is armed without it; check the temperature sensors.</source>
        <translation>Ohne sie wird nichts freigegeben; prüfen Sie die Temperatursensoren.</translation>
    </message>
    <message>
        <source>the coils would reach {} degC, more than {} degC</source>
        <translation>die Spulen würden {} °C erreichen, mehr als {} °C</translation>
    </message>
    <message>
        <source>Shorten it, use less current, or let the motor cool first. Nothing was armed.</source>
        <translation>Kürzen Sie die Bewegung, verwenden Sie weniger Strom, oder lassen Sie den Motor erst abkühlen. Nichts wurde freigegeben.</translation>
    </message>
    <message>
        <source>give it in SI units, e.g. J=5.5e-4</source>
        <translation>geben Sie sie in SI-Einheiten an, z. B. J=5.5e-4</translation>
    </message>
    <message>
        <source>{} = {} is not possible</source>
        <translation>{} = {} ist nicht möglich</translation>
    </message>
    <message>
        <source>it cannot be negative</source>
        <translation>sie kann nicht negativ sein</translation>
    </message>
    <message>
        <source>it must be more than zero</source>
        <translation>sie muss größer als null sein</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no constant of the motor</source>
        <translation>„{}“ ist keine Konstante des Motors</translation>
    </message>
    <message>
        <source>use J, c, Kf or phi</source>
        <translation>verwenden Sie J, c, Kf oder phi</translation>
    </message>
    <message>
        <source>the currents of the sweep are not finite numbers</source>
        <translation>die Ströme der Messreihe sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>write e.g. 1.6:4:0.2</source>
        <translation>schreiben Sie z. B. 1.6:4:0.2</translation>
    </message>
    <message>
        <source>the sweep needs 0 &lt; FROM &lt;= TO and STEP &gt; 0</source>
        <translation>die Messreihe braucht 0 &lt; VON &lt;= BIS und SCHRITT &gt; 0</translation>
    </message>
    <message>
        <source>{} A is beyond the device&apos;s limit of {} A</source>
        <translation>{} A liegt jenseits der Grenze des Geräts von {} A</translation>
    </message>
    <message>
        <source>end the sweep at or below limit.current</source>
        <translation>beenden Sie die Messreihe bei höchstens limit.current</translation>
    </message>
    <message>
        <source>a sweep of more than 29 currents does not fit the board</source>
        <translation>eine Messreihe mit mehr als 29 Strömen passt nicht in das Steuergerät</translation>
    </message>
    <message>
        <source>use a larger step</source>
        <translation>verwenden Sie eine größere Schrittweite</translation>
    </message>
    <message>
        <source>the recording holds hardly any rows</source>
        <translation>die Aufzeichnung enthält kaum Zeilen</translation>
    </message>
    <message>
        <source>record at least some seconds of motion</source>
        <translation>zeichnen Sie mindestens einige Sekunden Bewegung auf</translation>
    </message>
    <message>
        <source>the recording lacks position or current_command</source>
        <translation>der Aufzeichnung fehlt position oder current_command</translation>
    </message>
    <message>
        <source>it needs the columns time_s, position_rad and current_command_A</source>
        <translation>sie braucht die Spalten time_s, position_rad und current_command_A</translation>
    </message>
    <message>
        <source>the recording has {} rows a second, less than 100</source>
        <translation>die Aufzeichnung hat {} Zeilen je Sekunde, weniger als 100</translation>
    </message>
    <message>
        <source>record at 100 Hz or more</source>
        <translation>zeichnen Sie mit 100 Hz oder mehr auf</translation>
    </message>
    <message>
        <source>the rotor stopped</source>
        <translation>der Rotor blieb stehen</translation>
    </message>
    <message>
        <source>slower than {} rad/s</source>
        <translation>langsamer als {} rad/s</translation>
    </message>
    <message>
        <source>not steady at its end</source>
        <translation>am Ende nicht stationär</translation>
    </message>
    <message>
        <source>the motion does not bend enough to show c/J</source>
        <translation>die Bewegung krümmt sich nicht genug, um c/J zu zeigen</translation>
    </message>
    <message>
        <source>friction differs between the directions by {} % of its mean</source>
        <translation>die Reibung unterscheidet sich zwischen den Richtungen um {} % ihres Mittels</translation>
    </message>
    <message>
        <source>the mean of both directions is reported</source>
        <translation>angegeben ist das Mittel beider Richtungen</translation>
    </message>
    <message>
        <source>{} plateaus came to rest and were left out</source>
        <translation>{} Plateaus kamen zum Stillstand und wurden ausgelassen</translation>
    </message>
    <message>
        <source>start the sweep further above the breakaway current</source>
        <translation>beginnen Sie die Messreihe weiter über dem Losbrechstrom</translation>
    </message>
    <message>
        <source>dwell longer at each current</source>
        <translation>halten Sie jeden Strom länger</translation>
    </message>
    <message>
        <source>{} rows of the recording were lost</source>
        <translation>{} Zeilen der Aufzeichnung gingen verloren</translation>
    </message>
    <message>
        <source>run-ups and coast-downs could not be used: {}</source>
        <translation>Hochläufe und Ausläufe waren nicht zu verwenden: {}</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs at 100 Hz or more</source>
        <translation>zeichnen Sie Hochläufe und Ausläufe mit 100 Hz oder mehr auf</translation>
    </message>
    <message>
        <source>use a higher current, so that the coast-down above 3 rad/s lasts longer than 0.12 s, or a second current</source>
        <translation>verwenden Sie mehr Strom, damit der Auslauf über 3 rad/s länger als 0,12 s dauert, oder einen zweiten Strom</translation>
    </message>
    <message>
        <source>model inadequate: one stretch of motion lies {} times further off the model than most</source>
        <translation>Modell unzureichend: ein Bewegungsabschnitt liegt {}-mal weiter neben dem Modell als die meisten</translation>
    </message>
    <message>
        <source>friction may depend on speed: the intervals do not hold that error; use faster currents only</source>
        <translation>die Reibung hängt vielleicht von der Drehzahl ab: die Intervalle enthalten diesen Fehler nicht; verwenden Sie nur größere Ströme</translation>
    </message>
    <message>
        <source>the torque changes with the speed as no lag of the currents explains: the angle of commutation or the compensation of the stray field is wrong</source>
        <translation>das Drehmoment ändert sich mit der Drehzahl, wie es kein Nachlauf der Ströme erklärt: der Winkel der Kommutierung oder die Kompensation des Streufelds ist falsch</translation>
    </message>
    <message>
        <source>calibrate the stray field and the Hall sensors, then identify again</source>
        <translation>kalibrieren Sie das Streufeld und die Hall-Sensoren und identifizieren Sie dann erneut</translation>
    </message>
    <message>
        <source>ordinary and robust regression of the sweep differ by more than one standard error</source>
        <translation>gewöhnliche und robuste Regression der Messreihe unterscheiden sich um mehr als einen Standardfehler</translation>
    </message>
    <message>
        <source>look at the plateaus of low weight; repeat the sweep</source>
        <translation>sehen Sie sich die Plateaus mit kleinem Gewicht an; wiederholen Sie die Messreihe</translation>
    </message>
    <message>
        <source>the sweep is not a straight line (lack of fit, p = {})</source>
        <translation>die Messreihe ist keine Gerade (Anpassungsmangel, p = {})</translation>
    </message>
    <message>
        <source>friction may depend on speed; use only the range of speeds that matters</source>
        <translation>die Reibung hängt vielleicht von der Drehzahl ab; verwenden Sie nur den Drehzahlbereich, auf den es ankommt</translation>
    </message>
    <message>
        <source>residuals keep their sign over neighbouring speeds (runs test, p = {})</source>
        <translation>die Residuen behalten über benachbarte Drehzahlen ihr Vorzeichen (Runs-Test, p = {})</translation>
    </message>
    <message>
        <source>friction may depend on speed; look at the residuals</source>
        <translation>die Reibung hängt vielleicht von der Drehzahl ab; sehen Sie sich die Residuen an</translation>
    </message>
    <message>
        <source>leaving out one plateau moves the steady line by {} standard errors</source>
        <translation>ohne ein einzelnes Plateau verschiebt sich die stationäre Gerade um {} Standardfehler</translation>
    </message>
    <message>
        <source>add plateaus near it or repeat it</source>
        <translation>fügen Sie Plateaus in seiner Nähe hinzu, oder wiederholen Sie es</translation>
    </message>
    <message>
        <source>c/phi is {} A*s/rad from plateaus and {} from all motion (p = {})</source>
        <translation>c/phi ist {} A*s/rad aus den Plateaus und {} aus der ganzen Bewegung (p = {})</translation>
    </message>
    <message>
        <source>friction may depend on speed</source>
        <translation>die Reibung hängt vielleicht von der Drehzahl ab</translation>
    </message>
    <message>
        <source>the given constants contradict the data (p = {})</source>
        <translation>die vorgegebenen Konstanten widersprechen den Daten (p = {})</translation>
    </message>
    <message>
        <source>give only the constant that is known best</source>
        <translation>geben Sie nur die am besten bekannte Konstante vor</translation>
    </message>
    <message>
        <source>only ratios of the constants can be known from angle and current</source>
        <translation>aus Winkel und Strom sind nur Verhältnisse der Konstanten bestimmbar</translation>
    </message>
    <message>
        <source>give the inertia (--given J=...) or the torque constant (--given phi=...), or repeat with a known inertia fixed to the rotor (--bare, --added-inertia)</source>
        <translation>geben Sie das Trägheitsmoment (--given J=...) oder die Drehmomentkonstante (--given phi=...) vor, oder wiederholen Sie mit einer bekannten Trägheit am Rotor (--bare, --added-inertia)</translation>
    </message>
    <message>
        <source>the data and the given constants do not decide all four constants</source>
        <translation>die Daten und die vorgegebenen Konstanten bestimmen nicht alle vier Konstanten</translation>
    </message>
    <message>
        <source>add what is missing: transients (run-up and coast-down), or another given constant</source>
        <translation>ergänzen Sie, was fehlt: Übergänge (Hochlauf und Auslauf) oder eine weitere vorgegebene Konstante</translation>
    </message>
    <message>
        <source>both runs must decide c/J, K_f/J and phi/J with their covariance, and be made without given constants</source>
        <translation>beide Läufe müssen c/J, K_f/J und phi/J mit ihrer Kovarianz bestimmen und ohne vorgegebene Konstanten gemacht sein</translation>
    </message>
    <message>
        <source>identify the bare motor again without --given</source>
        <translation>identifizieren Sie den bloßen Motor neu ohne --given</translation>
    </message>
    <message>
        <source>damping tells another inertia ({} standard errors): the added part changed the friction</source>
        <translation>die Dämpfung ergibt ein anderes Trägheitsmoment ({} Standardfehler): das zugefügte Teil hat die Reibung verändert</translation>
    </message>
    <message>
        <source>only the torque constant was used</source>
        <translation>nur die Drehmomentkonstante wurde verwendet</translation>
    </message>
    <message>
        <source>neither transients nor plateaus could be used: {}; {}</source>
        <translation>weder Übergänge noch Plateaus waren zu verwenden: {}; {}</translation>
    </message>
    <message>
        <source>use currents well above the breakaway current and hold each for some seconds</source>
        <translation>verwenden Sie Ströme deutlich über dem Losbrechstrom, und halten Sie jeden einige Sekunden</translation>
    </message>
    <message>
        <source>sweep forward</source>
        <translation>Messreihe vorwärts</translation>
    </message>
    <message>
        <source>sweep reverse</source>
        <translation>Messreihe rückwärts</translation>
    </message>
    <message>
        <source>coast-downs forward</source>
        <translation>Ausläufe vorwärts</translation>
    </message>
    <message>
        <source>coast-downs reverse</source>
        <translation>Ausläufe rückwärts</translation>
    </message>
    <message>
        <source>the speed limit leaves no usable speed</source>
        <translation>die Drehzahlgrenze lässt keine brauchbare Drehzahl übrig</translation>
    </message>
    <message>
        <source>allow e.g. 40 rad/s</source>
        <translation>erlauben Sie z. B. 40 rad/s</translation>
    </message>
    <message>
        <source>0 to 16 coast-downs in each direction are possible</source>
        <translation>0 bis 16 Ausläufe in jeder Richtung sind möglich</translation>
    </message>
    <message>
        <source>first motion</source>
        <translation>erste Bewegung</translation>
    </message>
    <message>
        <source>the model does not hold {}, which decides the loop</source>
        <translation>das Modell enthält {} nicht, das den Regelkreis bestimmt</translation>
    </message>
    <message>
        <source>steady speeds alone do not show the inertia: identify with run-ups and coast-downs, or give the constant that is known (--given J=...)</source>
        <translation>stationäre Drehzahlen allein zeigen das Trägheitsmoment nicht: identifizieren Sie mit Hochläufen und Ausläufen, oder geben Sie die bekannte Konstante vor (--given J=...)</translation>
    </message>
    <message>
        <source>{} of the model is not a finite number</source>
        <translation>{} des Modells ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the covariance of the model names {} values but is not {} x {}</source>
        <translation>die Kovarianz des Modells nennt {} Werte, ist aber nicht {} x {}</translation>
    </message>
    <message>
        <source>the covariance of the model holds a value that is not finite</source>
        <translation>die Kovarianz des Modells enthält einen Wert, der nicht endlich ist</translation>
    </message>
    <message>
        <source>the covariance names &apos;{}&apos;, of which the model has no value</source>
        <translation>die Kovarianz nennt „{}“, wofür das Modell keinen Wert hat</translation>
    </message>
    <message>
        <source>the response has too few samples to be measured</source>
        <translation>die Antwort hat zu wenige Abtastwerte, um gemessen zu werden</translation>
    </message>
    <message>
        <source>Record longer or at a higher rate.</source>
        <translation>Zeichnen Sie länger oder mit höherer Rate auf.</translation>
    </message>
    <message>
        <source>the response holds a value that is not a number</source>
        <translation>die Antwort enthält einen Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>Repeat the move.</source>
        <translation>Wiederholen Sie die Bewegung.</translation>
    </message>
    <message>
        <source>{} degrees</source>
        <translation>{} Grad</translation>
    </message>
    <message>
        <source>a move of {} s is out of range</source>
        <translation>eine Bewegung von {} s ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Allowed: 0.05 to 3600 s.</source>
        <translation>Erlaubt: 0,05 bis 3600 s.</translation>
    </message>
    <message>
        <source>the board did not start its reference</source>
        <translation>das Steuergerät hat seinen Verlauf nicht gestartet</translation>
    </message>
    <message>
        <source>{} of {} samples arrived</source>
        <translation>{} von {} Abtastwerten kamen an</translation>
    </message>
    <message>
        <source>the board followed another reference than commanded, {} away</source>
        <translation>das Steuergerät folgte einem anderen Sollwert als befohlen, {} entfernt</translation>
    </message>
    <message>
        <source>waits for standstill</source>
        <translation>wartet auf Stillstand</translation>
    </message>
    <message>
        <source>the device knows no zero of its axes and does not find it</source>
        <translation>das Gerät kennt den Nullpunkt seiner Achsen nicht und findet ihn nicht</translation>
    </message>
    <message>
        <source>Check its sensors, home it, and move again. Nothing was armed.</source>
        <translation>Prüfen Sie seine Sensoren, referenzieren Sie es und fahren Sie erneut. Nichts wurde scharf geschaltet.</translation>
    </message>
    <message>
        <source>a {} needs {}</source>
        <translation>„{}“ braucht {}</translation>
    </message>
    <message>
        <source>Add {}=... to the reference.</source>
        <translation>Ergänzen Sie {}=... beim Verlauf.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not KEY=VALUE</source>
        <translation>„{}“ ist nicht SCHLÜSSEL=WERT</translation>
    </message>
    <message>
        <source>Write a reference like step,amplitude_deg=100. Known keys: {}.</source>
        <translation>Schreiben Sie einen Verlauf wie step,amplitude_deg=100. Bekannte Schlüssel: {}.</translation>
    </message>
    <message>
        <source>Write {}=1.5.</source>
        <translation>Schreiben Sie {}=1.5.</translation>
    </message>
    <message>
        <source>there is no reference shape &apos;{}&apos;</source>
        <translation>die Form „{}“ gibt es nicht</translation>
    </message>
    <message>
        <source>Known shapes: {}.</source>
        <translation>Bekannte Formen: {}.</translation>
    </message>
    <message>
        <source>a reference has no key &apos;{}&apos;</source>
        <translation>ein Verlauf hat keinen Schlüssel „{}“</translation>
    </message>
    <message>
        <source>Allowed: {} to {}.</source>
        <translation>Erlaubt: {} bis {}.</translation>
    </message>
    <message>
        <source>Allowed: {} to {}{}.</source>
        <translation>Erlaubt: {} bis {}{}.</translation>
    </message>
    <message>
        <source>{} does not go with the other keys: a length beside an angle</source>
        <translation>{} passt nicht zu den anderen Schlüsseln: eine Länge neben einem Winkel</translation>
    </message>
    <message>
        <source>reference: &apos;{}&apos; is given twice</source>
        <translation>Verlauf: „{}“ ist zweimal angegeben</translation>
    </message>
    <message>
        <source>axis {} turns, and the reference is a length</source>
        <translation>Achse {} dreht sich, und der Sollwert ist eine Länge</translation>
    </message>
    <message>
        <source>axis {} moves along a line, and the reference is an angle</source>
        <translation>Achse {} bewegt sich geradlinig, und der Sollwert ist ein Winkel</translation>
    </message>
    <message>
        <source>{} is not a number at {} s</source>
        <translation>{} ist bei {} s keine Zahl</translation>
    </message>
    <message>
        <source>The board or the link delivers damaged values; nothing was concluded from them.</source>
        <translation>Das Steuergerät oder die Verbindung liefert beschädigte Werte; daraus wurde nichts gefolgert.</translation>
    </message>
    <message>
        <source>the duration must be more than zero seconds</source>
        <translation>die Dauer muss größer als null Sekunden sein</translation>
    </message>
    <message>
        <source>Give e.g. --duration 10.</source>
        <translation>Geben Sie z. B. --duration 10 an.</translation>
    </message>
    <message>
        <source>Give e.g. --rate 100.</source>
        <translation>Geben Sie z. B. --rate 100 an.</translation>
    </message>
    <message>
        <source>a duration of {} s at {} Hz is more than {} rows</source>
        <translation>eine Dauer von {} s bei {} Hz ergibt mehr als {} Zeilen</translation>
    </message>
    <message>
        <source>Record in pieces or at a lower rate.</source>
        <translation>Zeichnen Sie in Teilen oder mit kleinerer Rate auf.</translation>
    </message>
    <message>
        <source>only {} of {} samples arrived</source>
        <translation>nur {} von {} Abtastwerten kamen an</translation>
    </message>
    <message>
        <source>{} of {} rows are missing</source>
        <translation>{} von {} Zeilen fehlen</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>the source&apos;s own targets (zeta 0.06 at 15 rad/s) give {} A/rad and {} A/(rad s) on this motor, not the printed 10 and 0.1</source>
        <translation>die eigenen Ziele der Quelle (zeta 0,06 bei 15 rad/s) ergeben an diesem Motor {} A/rad und {} A/(rad s), nicht die gedruckten 10 und 0,1</translation>
    </message>
    <message>
        <source>method designed has those gains</source>
        <translation>das Verfahren designed hat diese Reglerparameter</translation>
    </message>
    <message>
        <source>the motor damps more than the loop asks for: K_D is zero</source>
        <translation>der Motor dämpft mehr, als der Regelkreis verlangt: K_D ist null</translation>
    </message>
    <message>
        <source>a faster loop may be possible: method bandwidth or phase-margin</source>
        <translation>ein schnellerer Regelkreis ist vielleicht möglich: Verfahren bandwidth oder phase-margin</translation>
    </message>
    <message>
        <source>the model has no covariance: robustness is that of an exactly known motor</source>
        <translation>das Modell hat keine Kovarianz: die Robustheit ist die eines genau bekannten Motors</translation>
    </message>
    <message>
        <source>identify the motor to get its uncertainty</source>
        <translation>identifizieren Sie den Motor, um seine Unsicherheit zu erhalten</translation>
    </message>
    <message>
        <source>{} % of the motors that the data allow make this loop unstable</source>
        <translation>{} % der Motoren, die die Daten zulassen, machen diesen Regelkreis instabil</translation>
    </message>
    <message>
        <source>identify more precisely, or choose a slower loop</source>
        <translation>identifizieren Sie genauer, oder wählen Sie einen langsameren Regelkreis</translation>
    </message>
    <message>
        <source>the set of gains lacks {}</source>
        <translation>den Reglerparametern fehlt {}</translation>
    </message>
    <message>
        <source>{} = {} is negative</source>
        <translation>{} = {} ist negativ</translation>
    </message>
    <message>
        <source>the device has no parameter {}, which this set of gains needs</source>
        <translation>das Gerät hat keinen Parameter {}, den diese Reglerparameter brauchen</translation>
    </message>
    <message>
        <source>choose a method without it: pole-placement or a preset</source>
        <translation>wählen Sie ein Verfahren ohne ihn: pole-placement oder ein mitgelieferter Parametersatz</translation>
    </message>
    <message>
        <source>ended by the user</source>
        <translation>vom Benutzer beendet</translation>
    </message>
    <message>
        <source>the old gains run again</source>
        <translation>die alten Reglerparameter gelten wieder</translation>
    </message>
    <message>
        <source>no device is connected</source>
        <translation>kein Gerät ist verbunden</translation>
    </message>
    <message>
        <source>connect one first</source>
        <translation>verbinden Sie zuerst eines</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>Verbindung abgelehnt</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>Zeitüberschreitung der Verbindung</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>Verbindung von der Gegenseite abgebrochen</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>Netz nicht erreichbar</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>kein Weg zum Rechner</translation>
    </message>
    <message>
        <source>Name or service not known</source>
        <translation>Name oder Dienst nicht bekannt</translation>
    </message>
    <message>
        <source>Temporary failure in name resolution</source>
        <translation>vorübergehender Fehler der Namensauflösung</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>Adresse wird bereits verwendet</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz auf dem Datenträger</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ist kein Ordner</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Datei gibt es schon</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem nur lesbar</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>zu viele offene Dateien</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Unknown error</source>
        <translation>unbekannter Fehler</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: {}={}</source>
        <translation>Gerät „{}“: {}={}</translation>
    </message>
    <message>
        <source>use {}</source>
        <translation>verwenden Sie {}</translation>
    </message>
    <message>
        <source>give one octet in hexadecimal digits, like 9A</source>
        <translation>geben Sie ein Byte in Hexadezimalziffern an, wie 9A</translation>
    </message>
    <message>
        <source>give a whole number from {} to {}</source>
        <translation>geben Sie eine ganze Zahl von {} bis {} an</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: sync and escape are the same</source>
        <translation>Gerät „{}“: sync und escape sind gleich</translation>
    </message>
    <message>
        <source>give two different octets</source>
        <translation>geben Sie zwei verschiedene Byte an</translation>
    </message>
    <message>
        <source>{} is not open</source>
        <translation>{} ist nicht geöffnet</translation>
    </message>
    <message>
        <source>connect again</source>
        <translation>verbinden Sie erneut</translation>
    </message>
    <message>
        <source>{} (process {})</source>
        <translation>{} (Prozess {})</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>ein Programm</translation>
    </message>
    <message>
        <source>this program</source>
        <translation>dieses Programm</translation>
    </message>
    <message>
        <source>install the rules that &apos;halbench devices --udev-rules&apos; prints, then plug the device in again</source>
        <translation>installieren Sie die Regeln, die „halbench devices --udev-rules“ ausgibt, und stecken Sie das Gerät dann neu an</translation>
    </message>
    <message>
        <source>, or join the group with &apos;sudo usermod -aG {} $USER&apos; and log in again</source>
        <translation>, oder treten Sie mit „sudo usermod -aG {} $USER“ der Gruppe bei und melden Sie sich neu an</translation>
    </message>
    <message>
        <source>no permission to use {}</source>
        <translation>keine Berechtigung, {} zu verwenden</translation>
    </message>
    <message>
        <source>{} is in use by {}</source>
        <translation>{} wird verwendet von: {}</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>ein anderes Programm</translation>
    </message>
    <message>
        <source>disconnect it first</source>
        <translation>trennen Sie es zuerst</translation>
    </message>
    <message>
        <source>close that program (ModemManager lets go of a new port after some seconds)</source>
        <translation>schließen Sie jenes Programm (ModemManager gibt einen neuen Anschluss nach einigen Sekunden frei)</translation>
    </message>
    <message>
        <source>{} is not there</source>
        <translation>{} ist nicht da</translation>
    </message>
    <message>
        <source>plug the device in and see &apos;halbench devices&apos; for its address</source>
        <translation>stecken Sie das Gerät an; „halbench devices“ zeigt seine Adresse</translation>
    </message>
    <message>
        <source>check the cable and that the board is on</source>
        <translation>prüfen Sie das Kabel, und dass das Steuergerät eingeschaltet ist</translation>
    </message>
    <message>
        <source>name a serial port: see &apos;halbench devices&apos;</source>
        <translation>nennen Sie einen seriellen Anschluss: siehe „halbench devices“</translation>
    </message>
    <message>
        <source>{} cannot run at {} baud</source>
        <translation>{} kann nicht mit {} Baud laufen</translation>
    </message>
    <message>
        <source>use 115200 or a rate that the adapter knows</source>
        <translation>verwenden Sie 115200 oder eine Rate, die der Adapter kennt</translation>
    </message>
    <message>
        <source>serial:{}: the device was unplugged or switched off</source>
        <translation>serial:{}: das Gerät wurde abgezogen oder ausgeschaltet</translation>
    </message>
    <message>
        <source>serial:{}: the board takes no more commands</source>
        <translation>serial:{}: das Steuergerät nimmt keine Befehle mehr an</translation>
    </message>
    <message>
        <source>LEN byte</source>
        <translation>LEN als Byte</translation>
    </message>
    <message>
        <source>LEN+CTR byte</source>
        <translation>LEN+CTR als Byte</translation>
    </message>
    <message>
        <source>LEN+FILL byte</source>
        <translation>LEN+FILL als Byte</translation>
    </message>
    <message>
        <source>LEN word</source>
        <translation>LEN als Wort</translation>
    </message>
    <message>
        <source>LEN+CTR words</source>
        <translation>LEN+CTR als Wörter</translation>
    </message>
    <message>
        <source>LEN+FILL words</source>
        <translation>LEN+FILL als Wörter</translation>
    </message>
    <message>
        <source>no checksum</source>
        <translation>keine Prüfsumme</translation>
    </message>
    <message>
        <source>byte checksum</source>
        <translation>Prüfsumme als Byte</translation>
    </message>
    <message>
        <source>word checksum</source>
        <translation>Prüfsumme als Wort</translation>
    </message>
    <message>
        <source>not framed</source>
        <translation>ohne Rahmen</translation>
    </message>
    <message>
        <source>{} sends something ({} octets), but not in this protocol</source>
        <translation>{} sendet etwas ({} Byte), aber nicht in diesem Protokoll</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a finite number</source>
        <translation>„{}“ muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>a [[plot]] has both min and max, or neither; min is less than max</source>
        <translation>ein [[plot]] hat min und max oder keines von beiden; min ist kleiner als max</translation>
    </message>
    <message>
        <source>&apos;plot&apos; must be a list of tables, [[plot]]</source>
        <translation>„plot“ muss eine Liste von Tabellen sein, [[plot]]</translation>
    </message>
    <message>
        <source>&apos;monitor&apos; must be a table</source>
        <translation>„monitor“ muss eine Tabelle sein</translation>
    </message>
    <message>
        <source>&apos;span_s&apos; must be more than 0</source>
        <translation>„span_s“ muss größer als 0 sein</translation>
    </message>
    <message>
        <source>{}: given up</source>
        <translation>{}: aufgegeben</translation>
    </message>
    <message>
        <source>a stop was sent before the board had answered</source>
        <translation>ein Stopp wurde gesendet, bevor das Steuergerät geantwortet hatte</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>a stop came in between</source>
        <translation>ein Stopp kam dazwischen</translation>
    </message>
    <message>
        <source>release the stop again when the cause is gone</source>
        <translation>heben Sie den Stopp erneut auf, wenn die Ursache beseitigt ist</translation>
    </message>
    <message>
        <source>{} is open in another window (process {} on {})</source>
        <translation>{} ist in einem anderen Fenster geöffnet (Prozess {} auf {})</translation>
    </message>
    <message>
        <source>close it there; if it is open nowhere, remove {}</source>
        <translation>schließen Sie es dort; ist es nirgends geöffnet, löschen Sie {}</translation>
    </message>
    <message>
        <source>{}: the device was unplugged or switched off</source>
        <translation>{}: Das Gerät wurde abgesteckt oder ausgeschaltet</translation>
    </message>
    <message>
        <source>{} cannot be opened: {}</source>
        <translation>{} lässt sich nicht öffnen: {}</translation>
    </message>
    <message>
        <source>its serial port has no driver</source>
        <translation>Seine serielle Schnittstelle hat keinen Treiber</translation>
    </message>
    <message>
        <source>serial port</source>
        <translation>serielle Schnittstelle</translation>
    </message>
    <message>
        <source>USB bulk device</source>
        <translation>USB-Bulk-Gerät</translation>
    </message>
    <message>
        <source>HID device</source>
        <translation>HID-Gerät</translation>
    </message>
    <message>
        <source>no {} {} is plugged in</source>
        <translation>{} {} ist nicht angesteckt</translation>
    </message>
    <message>
        <source>{}: it is a {}</source>
        <translation>{}: Art des Geräts: {}</translation>
    </message>
    <message>
        <source>name it {}</source>
        <translation>nennen Sie es {}</translation>
    </message>
    <message>
        <source>{}: the one there has the serial number &apos;{}&apos;</source>
        <translation>{}: Das vorhandene hat die Seriennummer &apos;{}&apos;</translation>
    </message>
    <message>
        <source>plug the right one in, or name {}</source>
        <translation>stecken Sie das richtige an oder nennen Sie {}</translation>
    </message>
    <message>
        <source>plug it in and see &apos;halbench devices&apos; for its address</source>
        <translation>stecken Sie es an; &apos;halbench devices&apos; zeigt seine Adresse</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not VID:PID[:SERIAL]</source>
        <translation>&apos;{}&apos; ist nicht VID:PID[:SERIENNUMMER]</translation>
    </message>
    <message>
        <source>write both numbers in hexadecimal digits, like 1209:0001</source>
        <translation>schreiben Sie beide Zahlen hexadezimal, etwa 1209:0001</translation>
    </message>
    <message>
        <source>several devices {} are plugged in</source>
        <translation>Mehrere Geräte {} sind angesteckt</translation>
    </message>
    <message>
        <source>name one: {} or {}</source>
        <translation>nennen Sie eines: {} oder {}</translation>
    </message>
    <message>
        <source>USB cannot be used</source>
        <translation>USB lässt sich nicht verwenden</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>cannot be claimed</source>
        <translation>lässt sich nicht belegen</translation>
    </message>
    <message>
        <source>{}: the board halted its endpoint</source>
        <translation>{}: Das Steuergerät hat seinen Endpunkt angehalten</translation>
    </message>
    <message>
        <source>{}: the board takes no more commands</source>
        <translation>{}: Das Steuergerät nimmt keine Befehle mehr an</translation>
    </message>
    <message>
        <source>a stop came in between, so this was not done</source>
        <translation>ein Stopp kam dazwischen, daher wurde dies nicht getan</translation>
    </message>
    <message>
        <source>find out why it was stopped, then do it again</source>
        <translation>klären Sie, warum gestoppt wurde, und wiederholen Sie es dann</translation>
    </message>
    <message>
        <source>{}; it is not confirmed that the values from before are back: {}</source>
        <translation>{}; nicht bestätigt ist, dass die vorigen Werte wieder gelten: {}</translation>
    </message>
    <message>
        <source>connect again and compare the parameters before the actuator is armed</source>
        <translation>verbinden Sie neu und vergleichen Sie die Parameter, bevor der Aktor freigegeben wird</translation>
    </message>
    <message>
        <source>Current of one plateau</source>
        <translation>Strom eines Plateaus</translation>
    </message>
    <message>
        <source>output converter does not answer</source>
        <translation>Ausgangswandler antwortet nicht</translation>
    </message>
    <message>
        <source>{}: {} is not a finite number</source>
        <translation>{}: {} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>{}: {} is not from 0 to {}</source>
        <translation>{}: {} liegt nicht zwischen 0 und {}</translation>
    </message>
    <message>
        <source>give the share of the messages, e.g. 0.01 for one in a hundred</source>
        <translation>den Anteil der Nachrichten angeben, z. B. 0.01 für eine von hundert</translation>
    </message>
    <message>
        <source>give milliseconds, e.g. 20</source>
        <translation>Millisekunden angeben, z. B. 20</translation>
    </message>
    <message>
        <source>{} % of the recording&apos;s rows are missing</source>
        <translation>{} % der Zeilen der Aufzeichnung fehlen</translation>
    </message>
    <message>
        <source>{}: {}; that is not this protocol</source>
        <translation>{}: {}; das ist nicht dieses Protokoll</translation>
    </message>
    <message>
        <source>check address and port: another program listens there</source>
        <translation>Adresse und Port prüfen: dort antwortet ein anderes Programm</translation>
    </message>
    <message>
        <source>check that it is the right device and address, and on a serial line its baud rate and framing</source>
        <translation>prüfen, ob Gerät und Adresse stimmen, bei einer seriellen Leitung auch Baudrate und Rahmung</translation>
    </message>
    <message>
        <source>the board&apos;s description is cut off after {} octets</source>
        <translation>die Beschreibung des Steuergeräts bricht nach {} Bytes ab</translation>
    </message>
    <message>
        <source>connect again; if it stays so, the board&apos;s firmware holds only half of it and must be updated</source>
        <translation>erneut verbinden; bleibt es dabei, enthält die Firmware des Steuergeräts nur die Hälfte und muss erneuert werden</translation>
    </message>
    <message>
        <source>the firmware of &apos;{}&apos; changed: it was &apos;{}&apos; at an earlier connection and is &apos;{}&apos; now, so that its description was read anew</source>
        <translation>die Firmware von „{}“ hat sich geändert: bei einer früheren Verbindung war sie „{}“, jetzt ist sie „{}“; ihre Beschreibung wurde neu gelesen</translation>
    </message>
    <message>
        <source>the configuration is of a device of model &apos;{}&apos;, this one is of model &apos;{}&apos;</source>
        <translation>die Konfiguration ist von einem Gerät des Modells „{}“, dieses ist vom Modell „{}“</translation>
    </message>
    <message>
        <source>take a file of this model; nothing was written</source>
        <translation>nehmen Sie eine Datei dieses Modells; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>this device takes it as an order or does not let it be written</source>
        <translation>dieses Gerät versteht es als Befehl oder lässt es nicht schreiben</translation>
    </message>
    <message>
        <source>the file has it in &apos;{}&apos;, the device in &apos;{}&apos;</source>
        <translation>die Datei hat es in „{}“, das Gerät in „{}“</translation>
    </message>
    <message>
        <source>this device does not have it</source>
        <translation>dieses Gerät hat es nicht</translation>
    </message>
    <message>
        <source>{}.unit&quot; is &quot;{}&quot;, which is no unit of a value in &quot;{}&quot;</source>
        <translation>{}.unit&quot; ist &quot;{}&quot;, was keine Einheit eines Werts in &quot;{}&quot; ist</translation>
    </message>
    <message>
        <source>it is a ratio: leave its unit empty</source>
        <translation>es ist ein Verhältnis: die Einheit leer lassen</translation>
    </message>
    <message>
        <source>write the value in {} or a unit of the same quantity</source>
        <translation>den Wert in {} oder einer Einheit derselben Größe angeben</translation>
    </message>
    <message>
        <source>{}.unit&quot; must be a text</source>
        <translation>{}.unit&quot; muss ein Text sein</translation>
    </message>
    <message>
        <source>write &quot;{}&quot;</source>
        <translation>&quot;{}&quot; schreiben</translation>
    </message>
    <message>
        <source>the board&apos;s {} may still be {} instead of {} ms, as before it was armed: {}</source>
        <translation>{} des Steuergeräts ist vielleicht noch {} statt {} ms wie vor der Freigabe: {}</translation>
    </message>
    <message>
        <source>damping is undecided: between zero and {} % of the torque at the lowest frequency</source>
        <translation>die Dämpfung ist unbestimmt: zwischen null und {} % des Drehmoments bei der tiefsten Frequenz</translation>
    </message>
    <message>
        <source>measure from a lower frequency, more periods or with a larger amplitude</source>
        <translation>ab einer tieferen Frequenz, mehr Perioden oder mit größerer Amplitude messen</translation>
    </message>
    <message>
        <source>the board&apos;s clock started again: how much time lies before that row is not known</source>
        <translation>die Uhr des Steuergeräts begann neu: wie viel Zeit vor dieser Zeile liegt, ist nicht bekannt</translation>
    </message>
    <message>
        <source>look whether the board was reset; the recording has a gap there</source>
        <translation>prüfen, ob das Steuergerät zurückgesetzt wurde; die Aufzeichnung hat dort eine Lücke</translation>
    </message>
    <message>
        <source>the board ran firmware &apos;{}&apos;, but its description was of &apos;{}&apos;: names may have led to wrong values</source>
        <translation>das Steuergerät lief mit Firmware „{}“, ihre Beschreibung war von „{}“: Namen können zu falschen Werten geführt haben</translation>
    </message>
    <message>
        <source>record it again with the description of this firmware</source>
        <translation>mit der Beschreibung dieser Firmware neu aufzeichnen</translation>
    </message>
    <message>
        <source>the configuration was read from the device &apos;{}&apos;, this one is &apos;{}&apos;</source>
        <translation>die Konfiguration stammt vom Gerät „{}“, dieses ist „{}“</translation>
    </message>
    <message>
        <source>its calibration was measured there and is left out unless you ask for it</source>
        <translation>ihre Kalibrierung wurde dort gemessen und bleibt weg, wenn Sie sie nicht verlangen</translation>
    </message>
    <message>
        <source>the configuration was read from firmware &apos;{}&apos;, this device runs &apos;{}&apos;</source>
        <translation>die Konfiguration stammt von der Firmware „{}“, dieses Gerät läuft mit „{}“</translation>
    </message>
    <message>
        <source>look at each row: a value may mean something else there</source>
        <translation>sehen Sie jede Zeile an: ein Wert kann dort anderes bedeuten</translation>
    </message>
    <message>
        <source>the configuration has no value for &apos;{}&apos;</source>
        <translation>die Konfiguration hat keinen Wert für „{}“</translation>
    </message>
    <message>
        <source>choose among its rows; nothing was written</source>
        <translation>wählen Sie unter ihren Zeilen; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be restored: {}</source>
        <translation>„{}“ kann nicht wiederhergestellt werden: {}</translation>
    </message>
    <message>
        <source>leave it out; nothing was written</source>
        <translation>lassen Sie es weg; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>the actuator is armed; a configuration is not restored then</source>
        <translation>der Aktor ist freigegeben; dabei wird keine Konfiguration wiederhergestellt</translation>
    </message>
    <message>
        <source>disarm it first; nothing was written</source>
        <translation>sperren Sie ihn zuerst; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>the device keeps another value</source>
        <translation>das Gerät behält einen anderen Wert</translation>
    </message>
    <message>
        <source>nothing was written; mend this line or take another file</source>
        <translation>nichts wurde geschrieben; berichtigen Sie diese Zeile oder nehmen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was written by a newer Halbench</source>
        <translation>„{}“ wurde von einem neueren Halbench geschrieben</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a configuration; expected &apos;{}&apos;</source>
        <translation>„{}“ ist keine Konfiguration; erwartet wird „{}“</translation>
    </message>
    <message>
        <source>&apos;device.{}&apos; has no place there</source>
        <translation>„device.{}“ gehört nicht dorthin</translation>
    </message>
    <message>
        <source>&apos;{}&apos; stands twice</source>
        <translation>„{}“ steht zweimal da</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a table, [{}]</source>
        <translation>„{}“ muss eine Tabelle sein, [{}]</translation>
    </message>
    <message>
        <source>&apos;{}&apos; of &apos;{}&apos; is unknown; a row has value and unit</source>
        <translation>„{}“ von „{}“ ist unbekannt; eine Zeile hat value und unit</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no value</source>
        <translation>„{}“ hat keinen Wert</translation>
    </message>
    <message>
        <source>the value of &apos;{}&apos; must be a finite number</source>
        <translation>der Wert von „{}“ muss eine endliche Zahl sein</translation>
    </message>
    <message>
        <source>there is no schema = &quot;{}&quot;</source>
        <translation>es fehlt schema = &quot;{}&quot;</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;</source>
        <translation>unbekannter Schlüssel „{}“</translation>
    </message>
    <message>
        <source>&apos;given&apos; must be a table</source>
        <translation>„given“ muss eine Tabelle sein</translation>
    </message>
    <message>
        <source>given: {}</source>
        <translation>given: {}</translation>
    </message>
    <message>
        <source>one plateau came to rest and was left out</source>
        <translation>ein Plateau kam zum Stillstand und wurde ausgelassen</translation>
    </message>
    <message>
        <source>one plateau was too slow to tell friction from creep and was left out</source>
        <translation>ein Plateau war zu langsam, um Reibung von Kriechen zu unterscheiden, und wurde ausgelassen</translation>
    </message>
    <message>
        <source>{} plateaus were too slow to tell friction from creep and were left out</source>
        <translation>{} Plateaus waren zu langsam, um Reibung von Kriechen zu unterscheiden, und wurden ausgelassen</translation>
    </message>
    <message>
        <source>one plateau was not steady at its end and left out</source>
        <translation>ein Plateau war an seinem Ende nicht stationär und wurde ausgelassen</translation>
    </message>
    <message>
        <source>{} plateaus were not steady at their end and left out</source>
        <translation>{} Plateaus waren an ihrem Ende nicht stationär und wurden ausgelassen</translation>
    </message>
    <message>
        <source>one row of the recording was lost</source>
        <translation>eine Zeile der Aufzeichnung ging verloren</translation>
    </message>
    <message>
        <source>{} came back and was lost again {} times in a row</source>
        <translation>{} kam zurück und ging {} Mal hintereinander wieder verloren</translation>
    </message>
    <message>
        <source>another program may be using it, or a plug is loose; then connect again</source>
        <translation>vielleicht verwendet es ein anderes Programm oder ein Stecker ist lose; danach neu verbinden</translation>
    </message>
    <message>
        <source>another device answers at {}: {} instead of {}</source>
        <translation>an {} antwortet ein anderes Gerät: {} statt {}</translation>
    </message>
    <message>
        <source>plug the former one in again, or disconnect and connect this one</source>
        <translation>das frühere wieder einstecken, oder trennen und dieses verbinden</translation>
    </message>
    <message>
        <source>{} came back with other firmware: {} instead of {}</source>
        <translation>{} kam mit anderer Firmware zurück: {} statt {}</translation>
    </message>
    <message>
        <source>its signals and parameters may be others: disconnect, then connect again</source>
        <translation>seine Signale und Parameter können andere sein: trennen, dann neu verbinden</translation>
    </message>
    <message>
        <source>no device with the serial number &apos;{}&apos; is plugged in</source>
        <translation>kein Gerät mit der Seriennummer &apos;{}&apos; ist eingesteckt</translation>
    </message>
    <message>
        <source>plug it in; any port will do</source>
        <translation>einstecken; jeder Anschluss ist recht</translation>
    </message>
    <message>
        <source>several ports have the serial number &apos;{}&apos;: {} and {}</source>
        <translation>mehrere Anschlüsse haben die Seriennummer &apos;{}&apos;: {} und {}</translation>
    </message>
    <message>
        <source>name one of them</source>
        <translation>einen davon nennen</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>connection back</source>
        <translation>Verbindung wieder da</translation>
    </message>
    <message>
        <source>the device was changed before anything was written</source>
        <translation>das Gerät wurde gewechselt, bevor etwas geschrieben war</translation>
    </message>
    <message>
        <source>look at the rows again, then restore</source>
        <translation>sehen Sie die Zeilen noch einmal an, dann stellen Sie wieder her</translation>
    </message>
    <message>
        <source>recommended by the program for this motor</source>
        <translation>vom Programm für diesen Motor empfohlen</translation>
    </message>
    <message>
        <source>device &apos;{}&apos; describes itself and takes no file</source>
        <translation>Das Gerät &apos;{}&apos; beschreibt sich selbst und nimmt keine Datei</translation>
    </message>
    <message>
        <source>name the port of the board first, like tcp:HOST:PORT</source>
        <translation>zuerst den Anschluss des Steuergeräts nennen, etwa tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>the description &apos;{}&apos; cannot be read: {}</source>
        <translation>Die Beschreibung &apos;{}&apos; lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>give the A2L file that belongs to the board&apos;s firmware</source>
        <translation>die A2L-Datei angeben, die zur Firmware des Steuergeräts gehört</translation>
    </message>
    <message>
        <source>the description &apos;{}&apos; has {} octets</source>
        <translation>Die Beschreibung &apos;{}&apos; hat {} Oktette</translation>
    </message>
    <message>
        <source>known are baud, dtr, low_latency, framing, header, checksum, sync, escape, a2l</source>
        <translation>bekannt sind baud, dtr, low_latency, framing, header, checksum, sync, escape, a2l</translation>
    </message>
    <message>
        <source>a {}: address has no option but a2l</source>
        <translation>Eine {}:-Adresse hat keine Option außer a2l</translation>
    </message>
    <message>
        <source>no udev runs here, so that rules have no effect: allow it with &apos;sudo chmod a+rw {}&apos; each time it was plugged in</source>
        <translation>Hier läuft kein udev, Regeln wirken daher nicht: nach jedem Anstecken mit &apos;sudo chmod a+rw {}&apos; erlauben</translation>
    </message>
    <message>
        <source>the parameters of &apos;{}&apos; can only be read: the board runs on a page of it that takes no writes</source>
        <translation>Die Parameter von &apos;{}&apos; lassen sich nur lesen: Das Steuergerät läuft auf einer Seite davon, die kein Schreiben annimmt</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; is left out: {}</source>
        <translation>Parameter &apos;{}&apos; wird weggelassen: {}</translation>
    </message>
    <message>
        <source>this board does not say whether it stopped: use the switch at the actuator</source>
        <translation>Dieses Steuergerät sagt nicht, ob es angehalten hat: den Schalter am Aktor verwenden</translation>
    </message>
    <message>
        <source>give the A2L file that belongs to it: DEVICE?a2l=FILE</source>
        <translation>die zugehörige A2L-Datei angeben: GERÄT?a2l=DATEI</translation>
    </message>
    <message>
        <source>time does not rise from row {} to row {}</source>
        <translation>die Zeit steigt von Zeile {} zu Zeile {} nicht</translation>
    </message>
    <message>
        <source>a spectrum needs rows in the order of time</source>
        <translation>ein Spektrum braucht Zeilen in zeitlicher Reihenfolge</translation>
    </message>
    <message>
        <source>the rows are not evenly spaced: {} s before row {} where {} s are usual</source>
        <translation>die Zeilen haben keinen gleichmäßigen Abstand: {} s vor Zeile {}, üblich sind {} s</translation>
    </message>
    <message>
        <source>a spectrum needs a signal that was sampled at a constant rate; resample it first</source>
        <translation>ein Spektrum braucht ein mit fester Rate abgetastetes Signal; tasten Sie es zuvor neu ab</translation>
    </message>
    <message>
        <source>{} rows have no rate</source>
        <translation>{} Zeilen haben keine Rate</translation>
    </message>
    <message>
        <source>a spectrum needs a recording with more rows</source>
        <translation>ein Spektrum braucht eine Aufzeichnung mit mehr Zeilen</translation>
    </message>
    <message>
        <source>overlap, confidence and segment must be finite numbers</source>
        <translation>Überlappung, Vertrauensniveau und Segment müssen endliche Zahlen sein</translation>
    </message>
    <message>
        <source>an overlap of {} is not possible</source>
        <translation>eine Überlappung von {} ist nicht möglich</translation>
    </message>
    <message>
        <source>give a ratio from 0 to 0.95; 0.5 is usual, 0.75 for flat-top and blackman-harris</source>
        <translation>geben Sie ein Verhältnis von 0 bis 0.95 an; üblich ist 0.5, bei flat-top und blackman-harris 0.75</translation>
    </message>
    <message>
        <source>a confidence of {} is not between 0 and 1</source>
        <translation>ein Vertrauensniveau von {} liegt nicht zwischen 0 und 1</translation>
    </message>
    <message>
        <source>0.95 is usual</source>
        <translation>üblich ist 0.95</translation>
    </message>
    <message>
        <source>no {} rows follow each other without a gap or missing value</source>
        <translation>keine {} Zeilen folgen ohne Lücke oder fehlenden Wert aufeinander</translation>
    </message>
    <message>
        <source>record longer, or at a rate that the link carries without losses</source>
        <translation>zeichnen Sie länger auf oder mit einer Rate, die die Verbindung ohne Verluste überträgt</translation>
    </message>
    <message>
        <source>a segment of {} s has fewer than {} rows</source>
        <translation>ein Segment von {} s hat weniger als {} Zeilen</translation>
    </message>
    <message>
        <source>give at least {} s</source>
        <translation>geben Sie mindestens {} s an</translation>
    </message>
    <message>
        <source>a segment of {} s does not fit: the longest stretch without a gap or missing value has {} rows, {} s</source>
        <translation>ein Segment von {} s passt nicht: der längste Abschnitt ohne Lücke oder fehlenden Wert hat {} Zeilen, {} s</translation>
    </message>
    <message>
        <source>give a shorter segment, or record longer</source>
        <translation>geben Sie ein kürzeres Segment an oder zeichnen Sie länger auf</translation>
    </message>
    <message>
        <source>the rate is not constant: {} rows from {} s on take {} s where {} s are the average</source>
        <translation>die Rate ist nicht konstant: {} Zeilen ab {} s dauern {} s, im Mittel {} s</translation>
    </message>
    <message>
        <source>give a shorter segment, or a part of the recording with one rate</source>
        <translation>geben Sie ein kürzeres Segment an oder einen Teil der Aufzeichnung mit einer einzigen Rate</translation>
    </message>
    <message>
        <source>{} segments of {} lines are too many values for a spectrogram</source>
        <translation>{} Segmente zu {} Linien sind zu viele Werte für ein Spektrogramm</translation>
    </message>
    <message>
        <source>let the segments overlap less, or take a part of the recording</source>
        <translation>lassen Sie die Segmente weniger überlappen oder nehmen Sie einen Teil der Aufzeichnung</translation>
    </message>
    <message>
        <source>this version reads .csv, .mf4 and .csv.partial (an interrupted recording)</source>
        <translation>diese Version liest .csv, .mf4 und .csv.partial (eine abgebrochene Aufzeichnung)</translation>
    </message>
    <message>
        <source>line {}: {}</source>
        <translation>Zeile {}: {}</translation>
    </message>
    <message>
        <source>recording of {} {}</source>
        <translation>Aufzeichnung von {} {}</translation>
    </message>
    <message>
        <source>written by Halbench</source>
        <translation>von Halbench geschrieben</translation>
    </message>
    <message>
        <source>Halbench maintainers</source>
        <translation>Betreuer von Halbench</translation>
    </message>
    <message>
        <source>a parameter was changed</source>
        <translation>ein Parameter wurde geändert</translation>
    </message>
    <message>
        <source>the file is damaged or another program wrote it; let that program export CSV</source>
        <translation>die Datei ist beschädigt oder von einem anderen Programm; aus jenem Programm als CSV exportieren</translation>
    </message>
    <message>
        <source>{}: block {} at octet {}: {}</source>
        <translation>{}: Block {} bei Oktett {}: {}</translation>
    </message>
    <message>
        <source>it is not inside the file</source>
        <translation>er liegt nicht in der Datei</translation>
    </message>
    <message>
        <source>another block is there</source>
        <translation>dort steht ein anderer Block</translation>
    </message>
    <message>
        <source>its length {} cannot be</source>
        <translation>seine Länge {} kann nicht sein</translation>
    </message>
    <message>
        <source>it has other links</source>
        <translation>er hat andere Verweise</translation>
    </message>
    <message>
        <source>it is linked more than once</source>
        <translation>auf ihn wird mehr als einmal verwiesen</translation>
    </message>
    <message>
        <source>this is no MDF file</source>
        <translation>dies ist keine MDF-Datei</translation>
    </message>
    <message>
        <source>give a file that begins with &quot;MDF&quot;</source>
        <translation>eine Datei angeben, die mit &quot;MDF&quot; beginnt</translation>
    </message>
    <message>
        <source>the file is not finalised</source>
        <translation>die Datei ist nicht abgeschlossen</translation>
    </message>
    <message>
        <source>its writing was interrupted; write it again</source>
        <translation>ihr Schreiben wurde unterbrochen; noch einmal schreiben</translation>
    </message>
    <message>
        <source>version {}</source>
        <translation>Version {}</translation>
    </message>
    <message>
        <source>only version 410 is read</source>
        <translation>nur Version 410 wird gelesen</translation>
    </message>
    <message>
        <source>another program wrote the file</source>
        <translation>ein anderes Programm hat die Datei geschrieben</translation>
    </message>
    <message>
        <source>only MDF4 files of Halbench are read; let that program export CSV</source>
        <translation>nur MDF4-Dateien von Halbench werden gelesen; aus jenem Programm als CSV exportieren</translation>
    </message>
    <message>
        <source>the file is not sorted or has several groups</source>
        <translation>die Datei ist nicht sortiert oder hat mehrere Gruppen</translation>
    </message>
    <message>
        <source>it has flags, invalidation bits or a neighbour</source>
        <translation>er hat Merker, Ungültigkeitsbits oder einen Nachbarn</translation>
    </message>
    <message>
        <source>no signal can have this name</source>
        <translation>kein Signal kann so heißen</translation>
    </message>
    <message>
        <source>it is of another kind than time and 64-bit floats</source>
        <translation>er ist von anderer Art als Zeit und 64-Bit-Gleitkommazahlen</translation>
    </message>
    <message>
        <source>its rows do not hold its channels</source>
        <translation>seine Zeilen fassen seine Kanäle nicht</translation>
    </message>
    <message>
        <source>its time or its neighbour cannot be</source>
        <translation>seine Zeit oder sein Nachbar kann nicht sein</translation>
    </message>
    <message>
        <source>its length is not that of {} rows</source>
        <translation>seine Länge ist nicht die von {} Zeilen</translation>
    </message>
    <message>
        <source>row {}: the time does not increase</source>
        <translation>Zeile {}: die Zeit nimmt nicht zu</translation>
    </message>
    <message>
        <source>the board runs firmware &apos;{}&apos;, but its description is of &apos;{}&apos;: names may lead to wrong values, so nothing is written; give the description of this firmware, or update the board&apos;s firmware as a whole</source>
        <translation>auf dem Steuergerät läuft die Firmware &apos;{}&apos;, ihre Beschreibung gehört aber zu &apos;{}&apos;: Namen können zu falschen Werten führen, daher wird nichts geschrieben; geben Sie die Beschreibung dieser Firmware an oder erneuern Sie die Firmware des Steuergeräts als Ganzes</translation>
    </message>
    <message>
        <source>nothing is written: the description is not of the firmware that the board runs</source>
        <translation>nichts wird geschrieben: Die Beschreibung gehört nicht zu der Firmware, die auf dem Steuergerät läuft</translation>
    </message>
    <message>
        <source>give the description of this firmware, or update the board&apos;s firmware as a whole</source>
        <translation>geben Sie die Beschreibung dieser Firmware an oder erneuern Sie die Firmware des Steuergeräts als Ganzes</translation>
    </message>
    <message>
        <source>{}: another program works with this board</source>
        <translation>{}: Ein anderes Programm arbeitet mit dieser Steuerung</translation>
    </message>
    <message>
        <source>end that program&apos;s connection, then connect again; one that has gone silent is given up after a few seconds</source>
        <translation>Die Verbindung jenes Programms beenden, dann erneut verbinden; eines, das verstummt ist, wird nach wenigen Sekunden aufgegeben</translation>
    </message>
    <message>
        <source>this version writes .csv, .mf4 and .mat</source>
        <translation>diese Version schreibt .csv, .mf4 und .mat</translation>
    </message>
    <message>
        <source>MATLAB 5.0 MAT-file, written by Halbench</source>
        <translation>MATLAB-5.0-MAT-Datei, von Halbench geschrieben</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;: it is not complete</source>
        <translation>„{}“ kann nicht geschrieben werden: die Datei ist nicht vollständig</translation>
    </message>
    <message>
        <source>at most {} are read; write it in parts, with --from and --to</source>
        <translation>höchstens {} werden gelesen; in Teilen schreiben, mit --from und --to</translation>
    </message>
    <message>
        <source>give a finite number</source>
        <translation>geben Sie eine endliche Zahl an</translation>
    </message>
    <message>
        <source>a trigger without a source</source>
        <translation>ein Trigger ohne Quelle</translation>
    </message>
    <message>
        <source>give the name of a signal</source>
        <translation>geben Sie den Namen eines Signals an</translation>
    </message>
    <message>
        <source>level, hysteresis and times of a trigger must be finite numbers</source>
        <translation>Pegel, Hysterese und Zeiten eines Triggers müssen endliche Zahlen sein</translation>
    </message>
    <message>
        <source>a hysteresis of {} is negative</source>
        <translation>eine Hysterese von {} ist negativ</translation>
    </message>
    <message>
        <source>give 0 or how far the signal must have been on the other side of the level</source>
        <translation>geben Sie 0 an oder wie weit das Signal auf der anderen Seite des Pegels gewesen sein muss</translation>
    </message>
    <message>
        <source>a pre-trigger share of {} is not between 0 and 1</source>
        <translation>ein Vortrigger-Anteil von {} liegt nicht zwischen 0 und 1</translation>
    </message>
    <message>
        <source>0.25 shows a quarter of the window before the trigger</source>
        <translation>0.25 zeigt ein Viertel des Fensters vor dem Trigger</translation>
    </message>
    <message>
        <source>a trigger&apos;s window of {} s, hold-off of {} s and longest wait of {} s are not possible</source>
        <translation>ein Triggerfenster von {} s, eine Sperrzeit von {} s und eine längste Wartezeit von {} s sind nicht möglich</translation>
    </message>
    <message>
        <source>the window and the wait are longer than 0, the hold-off is not negative</source>
        <translation>Fenster und Wartezeit sind länger als 0, die Sperrzeit ist nicht negativ</translation>
    </message>
    <message>
        <source>correct the line; the forms are in resources/help/projects.md and command-line.md</source>
        <translation>berichtigen Sie die Zeile; die Formen stehen in resources/help/projects.md und command-line.md</translation>
    </message>
    <message>
        <source>the board neither tells its firmware nor shows the octets where its description keeps it: whether the two belong together is not known</source>
        <translation>Das Steuergerät nennt weder seine Firmware, noch zeigt es die Oktette, in denen sie laut Beschreibung steht: Ob beide zusammengehören, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the Nyquist curve runs through -1: the loop is on the limit of stability</source>
        <translation>die Nyquist-Kurve läuft durch -1: der Kreis liegt auf der Stabilitätsgrenze</translation>
    </message>
    <message>
        <source>change the gain a little</source>
        <translation>die Verstärkung ein wenig ändern</translation>
    </message>
    <message>
        <source>behind a dead time this loop does not fall below 1 at high frequency</source>
        <translation>hinter einer Totzeit fällt dieser Kreis bei hohen Frequenzen nicht unter 1</translation>
    </message>
    <message>
        <source>the dead time is not a finite number</source>
        <translation>die Totzeit ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a dead time of {} s is not possible</source>
        <translation>eine Totzeit von {} s ist nicht möglich</translation>
    </message>
    <message>
        <source>a system with {} s of dead time cannot be added to one with {} s</source>
        <translation>ein System mit {} s Totzeit lässt sich nicht zu einem mit {} s addieren</translation>
    </message>
    <message>
        <source>discretize both, or approximate their dead times, first</source>
        <translation>beide zuerst diskretisieren oder ihre Totzeiten annähern</translation>
    </message>
    <message>
        <source>{} rows dropped: the disk did not keep up</source>
        <translation>{} Zeilen ausgelassen: der Datenträger kam nicht nach</translation>
    </message>
    <message>
        <source>Stable, if what is assumed here is true:</source>
        <translation>Stabil, falls zutrifft, was hier angenommen ist:</translation>
    </message>
    <message>
        <source>Good: robustly stable</source>
        <translation>Gut: robust stabil</translation>
    </message>
    <message>
        <source>Good: stable</source>
        <translation>Gut: stabil</translation>
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
        <source>identify this device and tune with that model</source>
        <translation>identifizieren Sie dieses Gerät, und legen Sie mit diesem Modell aus</translation>
    </message>
    <message>
        <source>the model was identified on the {} &apos;{}&apos;, this device is the {} &apos;{}&apos;</source>
        <translation>das Modell wurde an {} „{}“ identifiziert, dieses Gerät ist {} „{}“</translation>
    </message>
    <message>
        <source>the model was identified on &apos;{}&apos; with other overrides than this device has</source>
        <translation>das Modell wurde an „{}“ mit anderen Vorgaben identifiziert, als dieses Gerät hat</translation>
    </message>
    <message>
        <source>{} MB from the board waited and nobody took them</source>
        <translation>{} MB vom Steuergerät warteten und niemand nahm sie ab</translation>
    </message>
    <message>
        <source>the computer was too busy or asleep: connect again, with fewer signals or a lower rate</source>
        <translation>Der Rechner war zu beschäftigt oder im Ruhezustand: erneut verbinden, mit weniger Signalen oder einer niedrigeren Rate</translation>
    </message>
    <message>
        <source>it is the console of this machine</source>
        <translation>Es ist die Konsole dieses Rechners</translation>
    </message>
    <message>
        <source>take another port, or start the machine without &apos;console=&apos; for this one</source>
        <translation>Einen anderen Anschluss nehmen oder den Rechner ohne &apos;console=&apos; für diesen starten</translation>
    </message>
    <message>
        <source>load it: sudo modprobe {}</source>
        <translation>Treiber laden: sudo modprobe {}</translation>
    </message>
    <message>
        <source>held by the kernel driver &apos;{}&apos;</source>
        <translation>vom Kernel-Treiber &apos;{}&apos; belegt</translation>
    </message>
    <message>
        <source>if it is the board, connect to {}: the driver is detached until you disconnect</source>
        <translation>Falls es das Steuergerät ist, mit {} verbinden: Der Treiber wird bis zum Trennen abgehängt</translation>
    </message>
    <message>
        <source>{}: the system has no memory left for USB transfers</source>
        <translation>{}: Das System hat keinen Speicher mehr für USB-Übertragungen</translation>
    </message>
    <message>
        <source>close other programs that use USB, or raise /sys/module/usbcore/parameters/usbfs_memory_mb</source>
        <translation>Andere Programme schließen, die USB verwenden, oder /sys/module/usbcore/parameters/usbfs_memory_mb erhöhen</translation>
    </message>
    <message>
        <source>the transfer failed</source>
        <translation>Die Übertragung ist fehlgeschlagen</translation>
    </message>
    <message>
        <source>{}: the kernel driver &apos;{}&apos; does not let go of it: {}</source>
        <translation>{}: Der Kernel-Treiber &apos;{}&apos; gibt es nicht frei: {}</translation>
    </message>
    <message>
        <source>unload the driver: sudo modprobe -r {}</source>
        <translation>Treiber entladen: sudo modprobe -r {}</translation>
    </message>
    <message>
        <source>the board sent more than was asked for</source>
        <translation>Das Steuergerät hat mehr gesendet als verlangt</translation>
    </message>
    <message>
        <source>{}; whether it has begun is not known, so it was ended</source>
        <translation>{}; ob es begonnen hat, ist nicht bekannt, daher wurde es beendet</translation>
    </message>
    <message>
        <source>see where the actuator stands, then start again; newer firmware of this board takes a lost answer without harm</source>
        <translation>sehen Sie nach, wo der Aktor steht, und starten Sie dann erneut; neuere Firmware dieses Steuergeräts verträgt eine verlorene Antwort</translation>
    </message>
    <message>
        <source>See where the rotor stands and that no other program uses the board, then move again.</source>
        <translation>Sehen Sie nach, wo der Rotor steht und dass kein anderes Programm das Steuergerät benutzt, und fahren Sie dann erneut.</translation>
    </message>
    <message>
        <source>See that no other program uses the board, then move again.</source>
        <translation>Sorgen Sie dafür, dass kein anderes Programm das Steuergerät benutzt, und fahren Sie dann erneut.</translation>
    </message>
    <message>
        <source>the rotor ended at {} instead of {} degrees</source>
        <translation>der Rotor endete bei {} statt bei {} Grad</translation>
    </message>
    <message>
        <source>axis {} ended at {} instead of {} {}</source>
        <translation>Achse {} endete bei {} statt bei {} {}</translation>
    </message>
    <message>
        <source>Move for longer; check the gains and that nothing blocks the rotor.</source>
        <translation>Fahren Sie länger; prüfen Sie die Reglerparameter und dass nichts den Rotor blockiert.</translation>
    </message>
    <message>
        <source>Move for longer; check the gains and that nothing is in the way.</source>
        <translation>Fahren Sie länger; prüfen Sie die Verstärkungen und dass nichts im Weg ist.</translation>
    </message>
    <message>
        <source>a move of {} {} leaves the window of {} {} of axis {}</source>
        <translation>eine Bewegung um {} {} verlässt das Fenster von {} {} der Achse {}</translation>
    </message>
    <message>
        <source>Move less, or set {} on the device. Nothing was armed.</source>
        <translation>Fahren Sie weniger weit, oder setzen Sie {} am Gerät. Nichts wurde scharf geschaltet.</translation>
    </message>
    <message>
        <source>the limit or level of a nonlinear element must be positive, its hysteresis not negative</source>
        <translation>Grenze oder Höhe eines nichtlinearen Glieds muss positiv sein, seine Hysterese nicht negativ</translation>
    </message>
    <message>
        <source>a root locus needs a loop with poles and a gain</source>
        <translation>eine Wurzelortskurve braucht einen Kreis mit Polen und einer Verstärkung</translation>
    </message>
    <message>
        <source>the largest gain of a root locus, {}, is not positive</source>
        <translation>die größte Verstärkung der Wurzelortskurve, {}, ist nicht positiv</translation>
    </message>
    <message>
        <source>the impulse response of this system begins with an impulse</source>
        <translation>die Impulsantwort dieses Systems beginnt mit einem Impuls</translation>
    </message>
    <message>
        <source>choose another rule, or add the filter that every real system has</source>
        <translation>eine andere Regel wählen oder das Filter hinzufügen, das jedes wirkliche System hat</translation>
    </message>
    <message>
        <source>this sampled system is not the image of a continuous one</source>
        <translation>dieses abgetastete System ist nicht das Abbild eines kontinuierlichen</translation>
    </message>
    <message>
        <source>a pole lies at zero or on the negative real axis: choose Tustin, or take delays out first</source>
        <translation>ein Pol liegt bei null oder auf der negativen reellen Achse: Tustin wählen oder zuerst Verzögerungen herausnehmen</translation>
    </message>
    <message>
        <source>poles and zeros can only be matched for one input and one output</source>
        <translation>Pole und Nullstellen lassen sich nur für einen Ein- und einen Ausgang abbilden</translation>
    </message>
    <message>
        <source>the system is already continuous</source>
        <translation>das System ist bereits kontinuierlich</translation>
    </message>
    <message>
        <source>a response needs a system with one input and one output</source>
        <translation>eine Antwort braucht ein System mit einem Ein- und einem Ausgang</translation>
    </message>
    <message>
        <source>a response needs ascending times, each with its input</source>
        <translation>eine Antwort braucht aufsteigende Zeiten, jede mit ihrem Eingang</translation>
    </message>
    <message>
        <source>systems with {} and {} signals cannot be connected</source>
        <translation>Systeme mit {} und {} Signalen lassen sich nicht verbinden</translation>
    </message>
    <message>
        <source>a zero, a pole or the gain of a system is not a finite number</source>
        <translation>eine Nullstelle, ein Pol oder die Verstärkung eines Systems ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a complex zero or pole lacks its conjugate partner</source>
        <translation>einer komplexen Nullstelle oder einem Pol fehlt der konjugierte Partner</translation>
    </message>
    <message>
        <source>a figure of the filter is not a finite number</source>
        <translation>eine Angabe des Filters ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>this filter is not possible: {} lies outside its range</source>
        <translation>dieses Filter ist nicht möglich: {} liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the targets of this design are not possible: they must be positive, Ms above 1</source>
        <translation>die Ziele dieses Entwurfs sind nicht möglich: sie müssen positiv sein, Ms über 1</translation>
    </message>
    <message>
        <source>the design is unstable in the sampled loop</source>
        <translation>der Entwurf ist im abgetasteten Kreis instabil</translation>
    </message>
    <message>
        <source>ask for less speed, or shorten the computing delay</source>
        <translation>weniger Schnelligkeit verlangen oder die Rechenzeit verkürzen</translation>
    </message>
    <message>
        <source>allow a larger Ms, or shorten the computing delay</source>
        <translation>ein größeres Ms zulassen oder die Rechenzeit verkürzen</translation>
    </message>
    <message>
        <source>the current limit must be positive</source>
        <translation>die Stromgrenze muss positiv sein</translation>
    </message>
    <message>
        <source>the weights of the regulator do not fit the system</source>
        <translation>die Gewichte des Reglers passen nicht zum System</translation>
    </message>
    <message>
        <source>no regulator stabilises this system with these weights</source>
        <translation>kein Regler stabilisiert dieses System mit diesen Gewichten</translation>
    </message>
    <message>
        <source>weigh every state that does not come to rest by itself</source>
        <translation>jeden Zustand gewichten, der nicht von selbst zur Ruhe kommt</translation>
    </message>
    <message>
        <source>a constant of the process model is not a finite number</source>
        <translation>eine Konstante des Streckenmodells ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>this tuning rule needs a process with a gain and a lag, and a time to close in</source>
        <translation>diese Einstellregel braucht eine Strecke mit Verstärkung und Verzögerung und eine Zeit für den geschlossenen Kreis</translation>
    </message>
    <message>
        <source>this process never swings under proportional control: it has no ultimate gain</source>
        <translation>diese Strecke schwingt unter Proportionalregelung nie: sie hat keine kritische Verstärkung</translation>
    </message>
    <message>
        <source>use SIMC or pole placement</source>
        <translation>SIMC oder Polvorgabe verwenden</translation>
    </message>
    <message>
        <source>a relay experiment needs a level, a period and a swing beyond its hysteresis</source>
        <translation>ein Relaisversuch braucht eine Höhe, eine Periode und einen Ausschlag über die Hysterese hinaus</translation>
    </message>
    <message>
        <source>none of the drawn plants is a motor</source>
        <translation>keine der gezogenen Strecken ist ein Motor</translation>
    </message>
    <message>
        <source>must be &apos;{}&apos;, &apos;{}&apos; or &apos;{}&apos;</source>
        <translation>muss &apos;{}&apos;, &apos;{}&apos; oder &apos;{}&apos; sein</translation>
    </message>
    <message>
        <source>&apos;trigger&apos; must be a table, [monitor.trigger]</source>
        <translation>&apos;trigger&apos; muss eine Tabelle sein, [monitor.trigger]</translation>
    </message>
    <message>
        <source>of a trigger window_s is more than 0, hysteresis and hold_off_s are not negative, pre_trigger_ratio is from 0 to 1</source>
        <translation>bei einem Trigger ist window_s größer als 0, hysteresis und hold_off_s sind nicht negativ, pre_trigger_ratio liegt zwischen 0 und 1</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be true or false</source>
        <translation>&apos;{}&apos; muss true oder false sein</translation>
    </message>
    <message>
        <source>0 stops, 1 starts the generator, 2 to 255 start it once</source>
        <translation>0 hält den Generator an, 1 startet ihn, 2 bis 255 starten ihn einmal</translation>
    </message>
    <message>
        <source>0 stops, 1 starts the capture, 2 to 255 start it once</source>
        <translation>0 hält die Erfassung an, 1 startet sie, 2 bis 255 starten sie einmal</translation>
    </message>
    <message>
        <source>whether it is released is not known</source>
        <translation>ob der Stopp aufgehoben ist, ist nicht bekannt</translation>
    </message>
    <message>
        <source>it is still stopped: {}</source>
        <translation>es ist weiterhin angehalten: {}</translation>
    </message>
    <message>
        <source>this system may keep no more than {} ms of this stream while the program is busy; what comes then is lost: raise its limit (sysctl net.core.rmem_max={}), take fewer signals or a lower rate, or connect by tcp:</source>
        <translation>dieses System hält vielleicht nur {} ms dieses Datenstroms, während das Programm beschäftigt ist; was danach kommt, geht verloren: heben Sie seine Grenze an (sysctl net.core.rmem_max={}), nehmen Sie weniger Signale oder eine niedrigere Rate, oder verbinden Sie über tcp:</translation>
    </message>
    <message>
        <source>the law on the board has no stage for a {} filter</source>
        <translation>das Regelgesetz im Steuergerät hat keine Stufe für ein {}-Filter</translation>
    </message>
    <message>
        <source>a resonance or noise is avoided by a lower crossover: method bandwidth, or lead</source>
        <translation>eine Resonanz oder Rauschen wird durch eine niedrigere Durchtrittsfrequenz gemieden: Verfahren bandwidth oder lead</translation>
    </message>
    <message>
        <source>SIMC, the internal-model rule of Skogestad, for lag and dead time</source>
        <translation>SIMC, die Regel von Skogestad mit innerem Modell, für Verzögerung und Totzeit</translation>
    </message>
    <message>
        <source>lambda tuning: the closed loop is a lag of the asked bandwidth, twice</source>
        <translation>Lambda-Einstellung: der geschlossene Kreis ist zweimal eine Verzögerung der verlangten Bandbreite</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, PID, from where the loop swings; a lively starting point</source>
        <translation>Ziegler und Nichols, PID, vom Schwingpunkt des Kreises aus; ein lebhafter Anfang</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, PI, from where the loop swings</source>
        <translation>Ziegler und Nichols, PI, vom Schwingpunkt des Kreises aus</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, P: half of the gain at which the loop swings</source>
        <translation>Ziegler und Nichols, P: die halbe Verstärkung, bei der der Kreis schwingt</translation>
    </message>
    <message>
        <source>linear-quadratic regulator, error and current weighed for the asked frequency</source>
        <translation>linear-quadratischer Regler, Fehler und Strom für die verlangte Frequenz gewichtet</translation>
    </message>
    <message>
        <source>the same with the error weighed by time: what lasts is punished</source>
        <translation>dasselbe, der Fehler mit der Zeit gewichtet: was andauert, zählt mehr</translation>
    </message>
    <message>
        <source>PD, the lead of the board, with the asked phase margin</source>
        <translation>PD, das Vorhalteglied des Steuergeräts, mit der verlangten Phasenreserve</translation>
    </message>
    <message>
        <source>PI, the lag of the board, through the asked crossover</source>
        <translation>PI, das Nachlaufglied des Steuergeräts, durch die verlangte Durchtrittsfrequenz</translation>
    </message>
    <message>
        <source>the law on the board has no filter on its derivative, these gains have one of {} s</source>
        <translation>das Regelgesetz im Steuergerät hat kein Filter am D-Anteil, diese Verstärkungen haben eines von {} s</translation>
    </message>
    <message>
        <source>leave the filter out (filter_s null): the board takes the difference over one sample; where its noise is too much, lower K_D</source>
        <translation>lassen Sie das Filter weg (filter_s null): das Steuergerät nimmt die Differenz über eine Abtastung; rauscht sie zu stark, verringern Sie K_D</translation>
    </message>
    <message>
        <source>the gains of this rule, K_P = {} A/rad, K_I = {} A/(rad s) and K_D = {} A s/rad, are unstable in the sampled loop: pole radius {}</source>
        <translation>die Verstärkungen dieser Regel, K_P = {} A/rad, K_I = {} A/(rad s) und K_D = {} A s/rad, sind im abgetasteten Regelkreis instabil: Polradius {}</translation>
    </message>
    <message>
        <source>this rule needs a motor that damps: its model has c/J = 0</source>
        <translation>diese Regel braucht einen Motor mit Dämpfung: sein Modell hat c/J = 0</translation>
    </message>
    <message>
        <source>use method bandwidth, phase-margin or lqr</source>
        <translation>verwenden Sie das Verfahren bandwidth, phase-margin oder lqr</translation>
    </message>
    <message>
        <source>ask for a lower bandwidth</source>
        <translation>verlangen Sie eine geringere Bandbreite</translation>
    </message>
    <message>
        <source>this rule leaves little damping: use method recommended, bandwidth or phase-margin</source>
        <translation>diese Regel lässt wenig Dämpfung: verwenden Sie das Verfahren recommended, bandwidth oder phase-margin</translation>
    </message>
    <message>
        <source>ask for a lower crossover, or use method lead or phase-margin</source>
        <translation>verlangen Sie eine niedrigere Durchtrittsfrequenz, oder verwenden Sie das Verfahren lead oder phase-margin</translation>
    </message>
    <message>
        <source>a design needs a name</source>
        <translation>ein Entwurf braucht einen Namen</translation>
    </message>
    <message>
        <source>there is a design &apos;{}&apos; already</source>
        <translation>es gibt schon einen Entwurf &apos;{}&apos;</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>one more sample of delay makes this loop unstable: its delay margin is {} ms</source>
        <translation>eine Abtastung mehr an Verzögerung macht diesen Regelkreis instabil: seine Totzeitreserve ist {} ms</translation>
    </message>
    <message>
        <source>make sure that the delay is known (delay.samples), or choose a slower loop</source>
        <translation>stellen Sie sicher, dass die Verzögerung bekannt ist (delay.samples), oder wählen Sie einen langsameren Regelkreis</translation>
    </message>
    <message>
        <source>the excited rows are not whole periods of three signals</source>
        <translation>Die angeregten Zeilen sind keine ganzen Perioden dreier Signale</translation>
    </message>
    <message>
        <source>{} periods say too little of the scatter</source>
        <translation>{} Perioden sagen zu wenig über die Streuung</translation>
    </message>
    <message>
        <source>measure at least {}</source>
        <translation>mindestens {} messen</translation>
    </message>
    <message>
        <source>the excited lines do not ascend below half the rate</source>
        <translation>Die angeregten Linien steigen nicht an oder reichen über die halbe Rate</translation>
    </message>
    <message>
        <source>an excited row holds no number</source>
        <translation>Eine angeregte Zeile enthält keine Zahl</translation>
    </message>
    <message>
        <source>the excitation did not reach the plant</source>
        <translation>Die Anregung hat die Strecke nicht erreicht</translation>
    </message>
    <message>
        <source>check that the reference generator ran</source>
        <translation>prüfen, ob der Sollwertgenerator lief</translation>
    </message>
    <message>
        <source>too few usable frequencies for a fit of the rotor</source>
        <translation>zu wenige brauchbare Frequenzen, um den Rotor anzupassen</translation>
    </message>
    <message>
        <source>measure more frequencies, or with more excitation</source>
        <translation>mehr Frequenzen messen, oder mit stärkerer Anregung</translation>
    </message>
    <message>
        <source>the measured response is not that of a rotor</source>
        <translation>Der gemessene Frequenzgang ist nicht der eines Rotors</translation>
    </message>
    <message>
        <source>look at its points; an angle error or a resonance may be in it</source>
        <translation>die Punkte ansehen; ein Winkelfehler oder eine Resonanz kann darin stecken</translation>
    </message>
    <message>
        <source>rows are missing near {} Hz: the periods do not fit together</source>
        <translation>In der Nähe von {} Hz fehlen Zeilen: Die Perioden passen nicht zusammen</translation>
    </message>
    <message>
        <source>no phase margin: the loop crosses nowhere on the frequencies that are used</source>
        <translation>Keine Phasenreserve: Der Kreis hat auf den verwendeten Frequenzen keinen Durchtritt</translation>
    </message>
    <message>
        <source>no phase margin: the loop crosses where frequencies were left out or are far apart</source>
        <translation>Keine Phasenreserve: Der Kreis hat seinen Durchtritt dort, wo Frequenzen weggelassen wurden oder weit auseinanderliegen</translation>
    </message>
    <message>
        <source>no phase margin: it lies between {} and {} deg, known to {} at best</source>
        <translation>Keine Phasenreserve: Sie liegt zwischen {} und {} Grad und ist bestenfalls auf {} bekannt</translation>
    </message>
    <message>
        <source>{} deg are allowed: measure more periods, and calibrate the sensors&apos; gain and the stray field first</source>
        <translation>Zulässig sind {} Grad: mehr Perioden messen, und vorher Verstärkung der Sensoren und Streufeld kalibrieren</translation>
    </message>
    <message>
        <source>no gain margin: the loop crosses nowhere on the frequencies that are used</source>
        <translation>Keine Amplitudenreserve: Der Kreis hat auf den verwendeten Frequenzen keinen Durchtritt</translation>
    </message>
    <message>
        <source>no gain margin: the loop crosses where frequencies were left out or are far apart</source>
        <translation>Keine Amplitudenreserve: Der Kreis hat seinen Durchtritt dort, wo Frequenzen weggelassen wurden oder weit auseinanderliegen</translation>
    </message>
    <message>
        <source>no gain margin: it lies between {} and {} dB, known to {} at best</source>
        <translation>Keine Amplitudenreserve: Sie liegt zwischen {} und {} dB und ist bestenfalls auf {} bekannt</translation>
    </message>
    <message>
        <source>{} dB are allowed: measure more periods, and calibrate the sensors&apos; gain and the stray field first</source>
        <translation>Zulässig sind {} dB: mehr Perioden messen, und vorher Verstärkung der Sensoren und Streufeld kalibrieren</translation>
    </message>
    <message>
        <source>measure up to a higher, or from a lower frequency</source>
        <translation>bis zu einer höheren oder ab einer tieferen Frequenz messen</translation>
    </message>
    <message>
        <source>measure with more periods or a larger amplitude there</source>
        <translation>dort mit mehr Perioden oder größerer Amplitude messen</translation>
    </message>
    <message>
        <source>{} of {} frequencies have a coherence below {} and were left out</source>
        <translation>{} von {} Frequenzen haben eine Kohärenz unter {} und wurden weggelassen</translation>
    </message>
    <message>
        <source>measure more periods or with a larger amplitude</source>
        <translation>mehr Perioden messen oder mit größerer Amplitude</translation>
    </message>
    <message>
        <source>the current reached its limit of {} A: the plant is right, the closed loop was not linear</source>
        <translation>Der Strom hat seine Grenze von {} A erreicht: Die Strecke stimmt, der geschlossene Kreis war nicht linear</translation>
    </message>
    <message>
        <source>use a smaller amplitude</source>
        <translation>eine kleinere Amplitude verwenden</translation>
    </message>
    <message>
        <source>the stray field was compensated for the measurement; on the board it is not</source>
        <translation>Für die Messung wurde das Streufeld kompensiert; auf dem Steuergerät wird es das nicht</translation>
    </message>
    <message>
        <source>switch stray.enabled on: the loop that was measured is the one with it</source>
        <translation>stray.enabled einschalten: Gemessen wurde der Kreis mit Kompensation</translation>
    </message>
    <message>
        <source>the points do not decide the constants of a rotor</source>
        <translation>Die Punkte legen die Konstanten eines Rotors nicht fest</translation>
    </message>
    <message>
        <source>measure more frequencies, from 0.5 Hz or lower</source>
        <translation>mehr Frequenzen messen, ab 0,5 Hz oder tiefer</translation>
    </message>
    <message>
        <source>the points lie {} times farther from the fitted rotor than they scatter</source>
        <translation>Die Punkte liegen {}-mal weiter vom angepassten Rotor entfernt, als sie streuen</translation>
    </message>
    <message>
        <source>its intervals are widened by that; look for a resonance or an angle error that turns with it</source>
        <translation>Die Intervalle sind darum verbreitert; nach einer Resonanz oder einem mitdrehenden Winkelfehler suchen</translation>
    </message>
    <message>
        <source>allowed: {} to {}</source>
        <translation>zulässig: {} bis {}</translation>
    </message>
    <message>
        <source>lowest frequency in Hz</source>
        <translation>tiefste Frequenz in Hz</translation>
    </message>
    <message>
        <source>highest frequency in Hz</source>
        <translation>höchste Frequenz in Hz</translation>
    </message>
    <message>
        <source>number of periods</source>
        <translation>Zahl der Perioden</translation>
    </message>
    <message>
        <source>least coherence</source>
        <translation>kleinste Kohärenz</translation>
    </message>
    <message>
        <source>amplitude in rad</source>
        <translation>Amplitude in rad</translation>
    </message>
    <message>
        <source>a base speed of {} rad/s is too slow: friction is a plain offset only while the rotor turns</source>
        <translation>Eine Grunddrehzahl von {} rad/s ist zu langsam: Nur solange der Rotor dreht, ist Reibung ein bloßer Versatz</translation>
    </message>
    <message>
        <source>use at least {} rad/s in either direction</source>
        <translation>mindestens {} rad/s in einer der Richtungen verwenden</translation>
    </message>
    <message>
        <source>base speed in rad/s</source>
        <translation>Grunddrehzahl in rad/s</translation>
    </message>
    <message>
        <source>an amplitude of {} deg swings the reference&apos;s speed by {} rad/s on a base of {} rad/s: the total would change its sign and friction would be no offset</source>
        <translation>Eine Amplitude von {} Grad lässt die Drehzahl des Sollwerts um {} rad/s schwanken, bei einer Grunddrehzahl von {} rad/s: Die Summe würde ihr Vorzeichen wechseln, und Reibung wäre kein Versatz</translation>
    </message>
    <message>
        <source>use at most {} deg, a faster base, fewer high frequencies, or leave the amplitude to the program</source>
        <translation>höchstens {} Grad, eine schnellere Grunddrehzahl oder weniger hohe Frequenzen verwenden, oder die Amplitude dem Programm überlassen</translation>
    </message>
    <message>
        <source>the rotor came down to {} rad/s on a base of {} rad/s: near standstill friction is no plain offset</source>
        <translation>Der Rotor fiel auf {} rad/s ab, bei einer Grunddrehzahl von {} rad/s: Nahe dem Stillstand ist Reibung kein bloßer Versatz</translation>
    </message>
    <message>
        <source>use a smaller amplitude or a faster base; a loop that swings by itself needs gains with more damping first</source>
        <translation>eine kleinere Amplitude oder schnellere Grunddrehzahl verwenden; ein Kreis, der von selbst schwingt, braucht erst besser gedämpfte Reglerparameter</translation>
    </message>
    <message>
        <source>runs up</source>
        <translation>läuft hoch</translation>
    </message>
    <message>
        <source>excites from {} Hz</source>
        <translation>regt ab {} Hz an</translation>
    </message>
    <message>
        <source>the board runs the printed difference equation, which is no set of gains</source>
        <translation>Das Steuergerät rechnet mit der gedruckten Differenzengleichung, die kein Satz von Reglerparametern ist</translation>
    </message>
    <message>
        <source>set control.law=0 first; nothing was armed</source>
        <translation>zuerst control.law=0 setzen; nichts wurde freigegeben</translation>
    </message>
    <message>
        <source>use a stepped sine</source>
        <translation>einen gestuften Sinus verwenden</translation>
    </message>
    <message>
        <source>there is no excitation &apos;{}&apos;</source>
        <translation>Es gibt keine Anregung „{}“</translation>
    </message>
    <message>
        <source>known: {}</source>
        <translation>bekannt: {}</translation>
    </message>
    <message>
        <source>a frequency response needs a board with a position loop of its own</source>
        <translation>Ein Frequenzgang braucht ein Steuergerät mit eigenem Lageregelkreis</translation>
    </message>
    <message>
        <source>the name &apos;{}&apos; is taken</source>
        <translation>der Name &apos;{}&apos; ist vergeben</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no name of a signal</source>
        <translation>&apos;{}&apos; ist kein Name eines Signals</translation>
    </message>
    <message>
        <source>letters, digits, dots and underscores; it does not begin with a digit or a dot</source>
        <translation>Buchstaben, Ziffern, Punkte und Unterstriche; er beginnt nicht mit einer Ziffer oder einem Punkt</translation>
    </message>
    <message>
        <source>the expression names no signal</source>
        <translation>Der Ausdruck nennt kein Signal</translation>
    </message>
    <message>
        <source>write names of signals as recordings have them, e.g. current.a</source>
        <translation>schreiben Sie Namen von Signalen wie in Aufzeichnungen, z. B. current.a</translation>
    </message>
    <message>
        <source>column {} of the expression: there is no signal &apos;{}&apos;</source>
        <translation>Spalte {} des Ausdrucks: Es gibt kein Signal „{}“</translation>
    </message>
    <message>
        <source>&apos;{}&apos; defines no signal</source>
        <translation>„{}“ legt kein Signal fest</translation>
    </message>
    <message>
        <source>write NAME = EXPRESSION or NAME [UNIT] = EXPRESSION</source>
        <translation>schreiben Sie NAME = AUSDRUCK oder NAME [EINHEIT] = AUSDRUCK</translation>
    </message>
    <message>
        <source>no unit follows from the expression</source>
        <translation>Aus dem Ausdruck folgt keine Einheit</translation>
    </message>
    <message>
        <source>write the unit of the result, 1 for a number; terms of a sum need equal units</source>
        <translation>schreiben Sie die Einheit des Ergebnisses, 1 für eine Zahl; Glieder einer Summe brauchen gleiche Einheiten</translation>
    </message>
    <message>
        <source>operators are + - * / ^ and comparisons, functions sin, cos, atan2, sqrt, abs, exp, ln, min, max</source>
        <translation>Operatoren sind + - * / ^ und Vergleiche, Funktionen sin, cos, atan2, sqrt, abs, exp, ln, min, max</translation>
    </message>
    <message>
        <source>column {} of the expression: it ends too early</source>
        <translation>Spalte {} des Ausdrucks: Er endet zu früh</translation>
    </message>
    <message>
        <source>column {} of the expression: a ) is missing</source>
        <translation>Spalte {} des Ausdrucks: Eine ) fehlt</translation>
    </message>
    <message>
        <source>every ( has its )</source>
        <translation>jede ( hat ihre )</translation>
    </message>
    <message>
        <source>column {} of the expression: a : is missing</source>
        <translation>Spalte {} des Ausdrucks: Ein : fehlt</translation>
    </message>
    <message>
        <source>every ? has its :</source>
        <translation>Zu jedem ? gehört ein :</translation>
    </message>
    <message>
        <source>column {} of the expression: too many arguments of {}</source>
        <translation>Spalte {} des Ausdrucks: Zu viele Argumente von {}</translation>
    </message>
    <message>
        <source>column {} of the expression: too few arguments of {}</source>
        <translation>Spalte {} des Ausdrucks: Zu wenige Argumente von {}</translation>
    </message>
    <message>
        <source>column {} of the expression: &apos;{}&apos; is not expected here</source>
        <translation>Spalte {} des Ausdrucks: „{}“ wird hier nicht erwartet</translation>
    </message>
    <message>
        <source>column {} of the expression: = sets nothing</source>
        <translation>Spalte {} des Ausdrucks: = setzt nichts</translation>
    </message>
    <message>
        <source>== compares</source>
        <translation>== vergleicht</translation>
    </message>
    <message>
        <source>the expression has more than {} letters</source>
        <translation>der Ausdruck hat mehr als {} Zeichen</translation>
    </message>
    <message>
        <source>divide it: a derived signal of a recording may use those before it</source>
        <translation>Teilen Sie ihn: Ein abgeleitetes Signal einer Aufzeichnung darf die vor ihm verwenden</translation>
    </message>
    <message>
        <source>the expression has several results</source>
        <translation>der Ausdruck hat mehrere Ergebnisse</translation>
    </message>
    <message>
        <source>write one; the comma separates arguments of functions</source>
        <translation>schreiben Sie eines; das Komma trennt Argumente von Funktionen</translation>
    </message>
    <message>
        <source>&apos;derived&apos; must be a list of tables, [[derived]]</source>
        <translation>&apos;derived&apos; muss eine Liste von Tabellen sein, [[derived]]</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a [[derived]] has name, expression, unit</source>
        <translation>unbekannter Schlüssel &apos;{}&apos;; ein [[derived]] hat name, expression, unit</translation>
    </message>
    <message>
        <source>a [[derived]] has a name and an expression</source>
        <translation>ein [[derived]] hat einen Namen und einen Ausdruck</translation>
    </message>
    <message>
        <source>the recording ends at {} s, before {} s</source>
        <translation>die Aufzeichnung endet bei {} s, vor {} s</translation>
    </message>
    <message>
        <source>begin earlier</source>
        <translation>früher beginnen</translation>
    </message>
    <message>
        <source>only recordings with their sidecar can have tags and notes</source>
        <translation>nur Aufzeichnungen mit ihrer Begleitdatei können Schlagwörter und Notizen haben</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is damaged</source>
        <translation>&apos;{}&apos; ist beschädigt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no rows</source>
        <translation>„{}“ hat keine Zeilen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has {} numbers, too many beside the others</source>
        <translation>„{}“ hat {} Zahlen, zu viele neben den anderen</translation>
    </message>
    <message>
        <source>compare fewer recordings, or parts of them (halbench convert --from --to)</source>
        <translation>vergleichen Sie weniger Aufzeichnungen oder Teile davon (halbench convert --from --to)</translation>
    </message>
    <message>
        <source>{}: schema: is not {}</source>
        <translation>{}: schema: ist nicht {}</translation>
    </message>
    <message>
        <source>make the file with &apos;halbench identify DEVICE --frequency --out&apos;</source>
        <translation>die Datei mit „halbench identify DEVICE --frequency --out“ erzeugen</translation>
    </message>
    <message>
        <source>{}: this response was refused</source>
        <translation>{}: Dieser Frequenzgang wurde verworfen</translation>
    </message>
    <message>
        <source>see its findings, then measure again</source>
        <translation>die Befunde ansehen und erneut messen</translation>
    </message>
    <message>
        <source>{}: sample_period_s: must be more than zero</source>
        <translation>{}: sample_period_s: muss größer als null sein</translation>
    </message>
    <message>
        <source>{}: points[{}]: needs a plant and a frequency above the one before, below half the rate</source>
        <translation>{}: points[{}]: braucht eine Strecke und eine Frequenz über der vorigen, unter der halben Rate</translation>
    </message>
    <message>
        <source>{}: points: there are none</source>
        <translation>{}: points: Es gibt keine</translation>
    </message>
    <message>
        <source>the response was measured every {} ms, this loop runs every {} ms</source>
        <translation>Der Frequenzgang wurde alle {} ms gemessen, dieser Kreis läuft alle {} ms</translation>
    </message>
    <message>
        <source>measure it on this board</source>
        <translation>auf diesem Steuergerät messen</translation>
    </message>
    <message>
        <source>--out {} would replace the recording itself</source>
        <translation>--out {} würde die Aufzeichnung selbst ersetzen</translation>
    </message>
    <message>
        <source>name another file</source>
        <translation>nennen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>no base speed from {} to {} rad/s keeps the turn&apos;s harmonics off the lines: a period lasts only {} s</source>
        <translation>keine Grunddrehzahl von {} bis {} rad/s hält die Oberschwingungen der Umdrehung von den Linien fern: Eine Periode dauert nur {} s</translation>
    </message>
    <message>
        <source>use a lower lowest frequency, which makes the period longer</source>
        <translation>wählen Sie eine tiefere unterste Frequenz, das macht die Periode länger</translation>
    </message>
    <message>
        <source>the history in &apos;{}&apos; cannot be read back: {}</source>
        <translation>der Verlauf in „{}“ kann nicht zurückgelesen werden: {}</translation>
    </message>
    <message>
        <source>damaged (checksum)</source>
        <translation>beschädigt (Prüfsumme)</translation>
    </message>
    <message>
        <source>what was recorded there is shown as a gap; recordings are not concerned; check the disk</source>
        <translation>was dort lag, erscheint als Lücke; Aufzeichnungen sind nicht betroffen; den Datenträger prüfen</translation>
    </message>
    <message>
        <source>no room for more history in &apos;{}&apos;: {}</source>
        <translation>kein Platz für weiteren Verlauf in „{}“: {}</translation>
    </message>
    <message>
        <source>the oldest samples are dropped earlier; recordings are not concerned; free disk space</source>
        <translation>die ältesten Abtastwerte entfallen früher; Aufzeichnungen sind nicht betroffen; Speicherplatz freigeben</translation>
    </message>
    <message>
        <source>cannot keep history in &apos;{}&apos;: {}</source>
        <translation>der Verlauf kann nicht in „{}“ abgelegt werden: {}</translation>
    </message>
    <message>
        <source>the oldest samples are dropped when memory is full; recordings are not concerned; check the folder and the disk</source>
        <translation>die ältesten Abtastwerte entfallen, wenn der Arbeitsspeicher voll ist; Aufzeichnungen sind nicht betroffen; Ordner und Datenträger prüfen</translation>
    </message>
    <message>
        <source>more than {} characters in a line</source>
        <translation>mehr als {} Zeichen in einer Zeile</translation>
    </message>
    <message>
        <source>the file may be damaged, or no recording</source>
        <translation>die Datei ist vielleicht beschädigt oder keine Aufzeichnung</translation>
    </message>
    <message>
        <source>its numbers need more than {} MB of memory</source>
        <translation>ihre Zahlen brauchen mehr als {} MB Arbeitsspeicher</translation>
    </message>
    <message>
        <source>cut the file into pieces that each begin with its first line</source>
        <translation>teilen Sie die Datei in Stücke, die je mit ihrer ersten Zeile beginnen</translation>
    </message>
    <message>
        <source>a stream&apos;s recording waits for a signal&apos;s level</source>
        <translation>die Aufzeichnung eines Datenstroms wartet auf den Pegel eines Signals</translation>
    </message>
    <message>
        <source>give --trigger SIGNAL&gt;LEVEL or SIGNAL&lt;LEVEL; now and reference belong to --capture</source>
        <translation>geben Sie --trigger SIGNAL&gt;PEGEL oder SIGNAL&lt;PEGEL an; now und reference gehören zu --capture</translation>
    </message>
    <message>
        <source>the time before the trigger must not be negative</source>
        <translation>die Zeit vor dem Trigger darf nicht negativ sein</translation>
    </message>
    <message>
        <source>Give e.g. --pre-trigger 2, in seconds.</source>
        <translation>Geben Sie z. B. --pre-trigger 2 an, in Sekunden.</translation>
    </message>
    <message>
        <source>there is a [[derived]] named &apos;{}&apos; already</source>
        <translation>es gibt schon ein [[derived]] mit dem Namen „{}“</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a list of texts</source>
        <translation>„{}“ muss eine Liste von Texten sein</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; [monitor.trigger] has on, source, mode, slope, level, hysteresis, window_s, pre_trigger_ratio, hold_off_s, board</source>
        <translation>unbekannter Schlüssel &apos;{}&apos;; [monitor.trigger] hat on, source, mode, slope, level, hysteresis, window_s, pre_trigger_ratio, hold_off_s, board</translation>
    </message>
    <message>
        <source>the board&apos;s capture was ended by somebody else</source>
        <translation>die Aufnahme des Steuergeräts wurde von anderer Seite beendet</translation>
    </message>
    <message>
        <source>another program may be using it; wait again to start it anew</source>
        <translation>ein anderes Programm benutzt sie vielleicht; erneut warten startet sie neu</translation>
    </message>
    <message>
        <source>the board gave nothing of its full capture</source>
        <translation>das Steuergerät gab nichts von seiner vollen Aufnahme</translation>
    </message>
    <message>
        <source>the board&apos;s capture is in a state that is not known</source>
        <translation>die Aufnahme des Steuergeräts ist in einem unbekannten Zustand</translation>
    </message>
    <message>
        <source>update Halbench, or the board&apos;s firmware</source>
        <translation>Halbench oder die Firmware des Steuergeräts aktualisieren</translation>
    </message>
    <message>
        <source>the crossover or margin asked for is not a finite number</source>
        <translation>die verlangte Durchtrittsfrequenz oder Reserve ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>no crossover makes a stable position loop of this motor</source>
        <translation>keine Durchtrittsfrequenz macht aus diesem Motor einen stabilen Lageregelkreis</translation>
    </message>
    <message>
        <source>identify the motor again, or choose a design method</source>
        <translation>identifizieren Sie den Motor neu, oder wählen Sie ein Auslegungsverfahren</translation>
    </message>
    <message>
        <source>the verification move was seen for {} of {} s</source>
        <translation>von der Prüfbewegung wurden {} von {} s gesehen</translation>
    </message>
    <message>
        <source>The old values run again. See that the link is not overloaded, and apply again.</source>
        <translation>Die alten Werte gelten wieder. Sorgen Sie dafür, dass die Verbindung nicht überlastet ist, und wenden Sie sie noch einmal an.</translation>
    </message>
    <message>
        <source>the device has several axes and none is named</source>
        <translation>das Gerät hat mehrere Achsen, und keine ist genannt</translation>
    </message>
    <message>
        <source>only one axis moves at a time, not all</source>
        <translation>es bewegt sich nur eine Achse auf einmal, nicht alle</translation>
    </message>
    <message>
        <source>the device has no axis &apos;{}&apos;</source>
        <translation>das Gerät hat keine Achse &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the swept rows are not whole sweeps of three signals</source>
        <translation>die durchfahrenen Zeilen sind keine ganzen Durchläufe dreier Signale</translation>
    </message>
    <message>
        <source>{} sweeps say too little of the scatter</source>
        <translation>{} Durchläufe sagen zu wenig über die Streuung</translation>
    </message>
    <message>
        <source>a swept row holds no number</source>
        <translation>eine durchfahrene Zeile enthält keine Zahl</translation>
    </message>
    <message>
        <source>a sweep is too short to tell its frequencies apart</source>
        <translation>ein Durchlauf ist zu kurz, um seine Frequenzen zu unterscheiden</translation>
    </message>
    <message>
        <source>{} values are more than are taken out of the plots at once</source>
        <translation>{} Werte sind mehr, als auf einmal aus den Diagrammen genommen werden</translation>
    </message>
    <message>
        <source>zoom in or set the cursors closer, or record it and cut the recording with halbench convert</source>
        <translation>hineinzoomen oder die Cursor näher setzen, oder aufzeichnen und die Aufzeichnung mit halbench convert schneiden</translation>
    </message>
    <message>
        <source>the plots have no samples in this stretch of time</source>
        <translation>die Diagramme haben in diesem Zeitabschnitt keine Messwerte</translation>
    </message>
    <message>
        <source>scroll to where there are some, or move the cursors</source>
        <translation>dorthin scrollen, wo es welche gibt, oder die Cursor verschieben</translation>
    </message>
    <message>
        <source>the generator of this board makes neither multisine nor chirp</source>
        <translation>der Generator dieses Steuergeräts erzeugt weder Multisinus noch Chirp</translation>
    </message>
    <message>
        <source>sweeps from {} to {} Hz, {} of {}</source>
        <translation>durchläuft {} bis {} Hz, {} von {}</translation>
    </message>
    <message>
        <source>waits for the last rows</source>
        <translation>wartet auf die letzten Zeilen</translation>
    </message>
    <message>
        <source>no phase margin: where the loop crosses its phase is not bounded at all</source>
        <translation>keine Phasenreserve: Wo der Kreis schneidet, ist seine Phase überhaupt nicht begrenzt</translation>
    </message>
    <message>
        <source>no gain margin: where the loop crosses its magnitude is not bounded at all</source>
        <translation>keine Amplitudenreserve: Wo der Kreis schneidet, ist sein Betrag überhaupt nicht begrenzt</translation>
    </message>
    <message>
        <source>a band of steps of this height and length is not possible</source>
        <translation>ein Band von Sprüngen dieser Höhe und Länge ist nicht möglich</translation>
    </message>
    <message>
        <source>the model has no covariance: how uncertain it is is not known</source>
        <translation>das Modell hat keine Kovarianz: wie unsicher es ist, ist nicht bekannt</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a pair of [[cursors]] has name, a_s, b_s, measuring</source>
        <translation>unbekannter Schlüssel &apos;{}&apos;; ein Paar von [[cursors]] hat name, a_s, b_s, measuring</translation>
    </message>
    <message>
        <source>a pair of [[cursors]] has a name, a_s and b_s</source>
        <translation>ein Paar von [[cursors]] hat einen Namen (name), a_s und b_s</translation>
    </message>
    <message>
        <source>&apos;cursors&apos; must be a list of tables, [[cursors]]</source>
        <translation>&apos;cursors&apos; muss eine Liste von Tabellen sein, [[cursors]]</translation>
    </message>
    <message>
        <source>there is a pair of [[cursors]] named &apos;{}&apos; already</source>
        <translation>ein Paar von [[cursors]] namens &apos;{}&apos; gibt es schon</translation>
    </message>
    <message>
        <source>only one pair of [[cursors]] is measuring</source>
        <translation>nur ein Paar von [[cursors]] misst (measuring)</translation>
    </message>
    <message>
        <source>a quoted cell does not end as it should</source>
        <translation>eine Zelle in Anführungszeichen endet nicht, wie sie sollte</translation>
    </message>
    <message>
        <source>{} cells where there are {} before</source>
        <translation>{} Zellen, wo es davor {} sind</translation>
    </message>
    <message>
        <source>the names of several columns where there is one</source>
        <translation>die Namen mehrerer Spalten, wo es eine gibt</translation>
    </message>
    <message>
        <source>there are no rows of numbers</source>
        <translation>es gibt keine Zeilen mit Zahlen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is written with thousands separators</source>
        <translation>„{}“ ist mit Tausendertrennzeichen geschrieben</translation>
    </message>
    <message>
        <source>{} columns are called &apos;{}&apos;</source>
        <translation>{} Spalten heißen „{}“</translation>
    </message>
    <message>
        <source>give its number: {} or {}</source>
        <translation>geben Sie ihre Nummer an: {} oder {}</translation>
    </message>
    <message>
        <source>the table has no column &apos;{}&apos;</source>
        <translation>die Tabelle hat keine Spalte „{}“</translation>
    </message>
    <message>
        <source>it has {}; a number from 1 to {} also names one</source>
        <translation>sie hat {}; auch eine Nummer von 1 bis {} nennt eine</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no unit that is known</source>
        <translation>„{}“ ist keine bekannte Einheit</translation>
    </message>
    <message>
        <source>for example s, ms, us, rad, deg, rad/s, rpm, A, mA, T, mT, degC, or - for none</source>
        <translation>zum Beispiel s, ms, us, rad, deg, rad/s, rpm, A, mA, T, mT, degC, oder - für keine</translation>
    </message>
    <message>
        <source>which column is the time is not certain</source>
        <translation>welche Spalte die Zeit ist, ist nicht sicher</translation>
    </message>
    <message>
        <source>column {}</source>
        <translation>Spalte {}</translation>
    </message>
    <message>
        <source>there is none: F rows a second</source>
        <translation>es gibt keine: F Zeilen in der Sekunde</translation>
    </message>
    <message>
        <source>the unit of column &apos;{}&apos; is not known</source>
        <translation>die Einheit der Spalte „{}“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>its numbers are in {}</source>
        <translation>ihre Zahlen sind in {}</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is in {}, which is no time</source>
        <translation>Spalte „{}“ ist in {}, was keine Zeit ist</translation>
    </message>
    <message>
        <source>choose another with --time, or say its unit with --unit</source>
        <translation>wählen Sie mit --time eine andere, oder nennen Sie mit --unit ihre Einheit</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is in {}, but {} is in {}</source>
        <translation>Spalte „{}“ ist in {}, aber {} ist in {}</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>keine Einheit</translation>
    </message>
    <message>
        <source>map another column with --map, or say its unit with --unit</source>
        <translation>ordnen Sie mit --map eine andere Spalte zu, oder nennen Sie mit --unit ihre Einheit</translation>
    </message>
    <message>
        <source>choose the time&apos;s column with --time, or give --rate_Hz</source>
        <translation>wählen Sie die Zeitspalte mit --time, oder geben Sie --rate_Hz an</translation>
    </message>
    <message>
        <source>how columns and numbers are written is not certain</source>
        <translation>wie Spalten und Zahlen geschrieben sind, ist nicht sicher</translation>
    </message>
    <message>
        <source> (thousands separators, which are not read: remove them)</source>
        <translation> (Tausendertrennzeichen, die nicht gelesen werden: entfernen Sie sie)</translation>
    </message>
    <message>
        <source>whether line {} is a row of numbers or of {} is not certain</source>
        <translation>ob Zeile {} eine Zeile mit Zahlen oder mit {} ist, ist nicht sicher</translation>
    </message>
    <message>
        <source>no header: numbers from the first line on</source>
        <translation>keine Kopfzeile: Zahlen von der ersten Zeile an</translation>
    </message>
    <message>
        <source>one line of names</source>
        <translation>eine Zeile mit Namen</translation>
    </message>
    <message>
        <source>a line of names, then one of units</source>
        <translation>eine Zeile mit Namen, dann eine mit Einheiten</translation>
    </message>
    <message>
        <source>write numbers without them</source>
        <translation>schreiben Sie Zahlen ohne sie</translation>
    </message>
    <message>
        <source>a table has rows of equally many numbers, at most two lines of names and units before them, and comments that begin with #; --separator, --decimal and --header say how it is written</source>
        <translation>eine Tabelle hat Zeilen mit gleich vielen Zahlen, davor höchstens zwei Zeilen mit Namen und Einheiten, und Kommentare, die mit # beginnen; --separator, --decimal und --header sagen, wie sie geschrieben ist</translation>
    </message>
    <message>
        <source>UTF-16 text</source>
        <translation>UTF-16-Text</translation>
    </message>
    <message>
        <source>zeros, so this is no text</source>
        <translation>Nullbytes, also ist dies kein Text</translation>
    </message>
    <message>
        <source>save it as text in UTF-8</source>
        <translation>speichern Sie sie als Text in UTF-8</translation>
    </message>
    <message>
        <source>{}:1:1: the lines end with CR alone</source>
        <translation>{}:1:1: die Zeilen enden mit CR allein</translation>
    </message>
    <message>
        <source>save it with line ends LF or CR LF</source>
        <translation>speichern Sie sie mit Zeilenenden LF oder CR LF</translation>
    </message>
    <message>
        <source>{}:1:1: there are no rows</source>
        <translation>{}:1:1: es gibt keine Zeilen</translation>
    </message>
    <message>
        <source>give a file with rows of numbers</source>
        <translation>geben Sie eine Datei mit Zeilen von Zahlen an</translation>
    </message>
    <message>
        <source>{}:{}:1: the line has {} characters</source>
        <translation>{}:{}:1: die Zeile hat {} Zeichen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no number that can be held</source>
        <translation>„{}“ ist keine Zahl, die gehalten werden kann</translation>
    </message>
    <message>
        <source>numbers reach from about 1e-308 to 1e308</source>
        <translation>Zahlen reichen von etwa 1e-308 bis 1e308</translation>
    </message>
    <message>
        <source>numbers of this table are written like -1{}5e-3; --decimal says otherwise</source>
        <translation>Zahlen dieser Tabelle sind geschrieben wie -1{}5e-3; --decimal sagt es anders</translation>
    </message>
    <message>
        <source>the line has {} characters</source>
        <translation>die Zeile hat {} Zeichen</translation>
    </message>
    <message>
        <source>a quote inside a quoted cell is written twice</source>
        <translation>ein Anführungszeichen in einer solchen Zelle wird doppelt geschrieben</translation>
    </message>
    <message>
        <source>{} cells where the table has {} columns</source>
        <translation>{} Zellen, wo die Tabelle {} Spalten hat</translation>
    </message>
    <message>
        <source>the time is missing</source>
        <translation>die Zeit fehlt</translation>
    </message>
    <message>
        <source>remove the row, or give --rate_Hz instead</source>
        <translation>entfernen Sie die Zeile, oder geben Sie stattdessen --rate_Hz an</translation>
    </message>
    <message>
        <source>the time does not increase: {} s after {} s</source>
        <translation>die Zeit nimmt nicht zu: {} s nach {} s</translation>
    </message>
    <message>
        <source>sort the rows by time, choose another column with --time, or give --rate_Hz</source>
        <translation>ordnen Sie die Zeilen nach der Zeit, wählen Sie mit --time eine andere Spalte, oder geben Sie --rate_Hz an</translation>
    </message>
    <message>
        <source>--rate_Hz: not between 1e-6 and 1e9</source>
        <translation>--rate_Hz: nicht zwischen 1e-6 und 1e9</translation>
    </message>
    <message>
        <source>give how many rows were sampled in a second</source>
        <translation>geben Sie an, wie viele Zeilen in der Sekunde abgetastet wurden</translation>
    </message>
    <message>
        <source>--time and --rate_Hz both say where the time comes from</source>
        <translation>--time und --rate_Hz sagen beide, woher die Zeit kommt</translation>
    </message>
    <message>
        <source>give one of them</source>
        <translation>geben Sie eines davon an</translation>
    </message>
    <message>
        <source>{}: {} columns</source>
        <translation>{}: {} Spalten</translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation>Einheit nicht bekannt</translation>
    </message>
    <message>
        <source>the unit &apos;{}&apos; of column &apos;{}&apos; is not known: its numbers stay as they are, without a unit</source>
        <translation>die Einheit „{}“ der Spalte „{}“ ist nicht bekannt: ihre Zahlen bleiben, wie sie sind, ohne Einheit</translation>
    </message>
    <message>
        <source>say its unit with --unit</source>
        <translation>nennen Sie mit --unit ihre Einheit</translation>
    </message>
    <message>
        <source>the steps of the time lie between {} s and {} s</source>
        <translation>die Schritte der Zeit liegen zwischen {} s und {} s</translation>
    </message>
    <message>
        <source>the times are kept as they are; what needs an even rate may refuse them</source>
        <translation>die Zeiten bleiben, wie sie sind; was gleichmäßige Schritte braucht, lehnt sie vielleicht ab</translation>
    </message>
    <message>
        <source>{} rows are missing</source>
        <translation>{} Zeilen fehlen</translation>
    </message>
    <message>
        <source>the sidecar says where</source>
        <translation>die Begleitdatei sagt, wo</translation>
    </message>
    <message>
        <source>a [[plot]] with its own time axis has own_span_s, which is more than 0</source>
        <translation>ein [[plot]] mit eigener Zeitachse hat own_span_s, größer als 0</translation>
    </message>
    <message>
        <source>{}: there is such a file already</source>
        <translation>{}: eine solche Datei gibt es schon</translation>
    </message>
    <message>
        <source>give the recording another name</source>
        <translation>geben Sie der Aufzeichnung einen anderen Namen</translation>
    </message>
    <message>
        <source>the import was cancelled</source>
        <translation>der Import wurde abgebrochen</translation>
    </message>
    <message>
        <source>{}: cannot be read</source>
        <translation>{}: kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>look whether it is still there</source>
        <translation>sehen Sie nach, ob sie noch da ist</translation>
    </message>
    <message>
        <source>nothing is shown that could be saved</source>
        <translation>es wird nichts gezeigt, was gespeichert werden könnte</translation>
    </message>
    <message>
        <source>wait until there is a picture</source>
        <translation>warten Sie, bis es ein Bild gibt</translation>
    </message>
    <message>
        <source>the measured motion left the predicted band at {} s, by {} degrees</source>
        <translation>die gemessene Bewegung hat das vorhergesagte Band bei {} s verlassen, um {} Grad</translation>
    </message>
    <message>
        <source>step {} of {} is not safe: {} % of the motors that the data allow make its loop unstable, its margins are {} deg and {}</source>
        <translation>Schritt {} von {} ist nicht sicher: {} % der Motoren, die die Daten zulassen, machen seinen Kreis instabil, seine Reserven sind {} Grad und {}</translation>
    </message>
    <message>
        <source>nothing was written; choose gains with larger margins, or identify more precisely</source>
        <translation>nichts wurde geschrieben; Reglerparameter mit größeren Reserven wählen oder genauer identifizieren</translation>
    </message>
    <message>
        <source>steps of a factor {} do not get anywhere</source>
        <translation>Schritte um den Faktor {} führen nirgendwohin</translation>
    </message>
    <message>
        <source>allow at least 1.05</source>
        <translation>mindestens 1,05 zulassen</translation>
    </message>
    <message>
        <source>the way to these gains takes more than 40 steps</source>
        <translation>der Weg zu diesen Reglerparametern braucht mehr als 40 Schritte</translation>
    </message>
    <message>
        <source>allow larger steps, or apply gains that are nearer first</source>
        <translation>größere Schritte zulassen oder zuerst nähere Reglerparameter übernehmen</translation>
    </message>
    <message>
        <source>step {} of {}: {}</source>
        <translation>Schritt {} von {}: {}</translation>
    </message>
    <message>
        <source>more than a twentieth of the measured motion was outside the predicted band</source>
        <translation>mehr als ein Zwanzigstel der gemessenen Bewegung lag außerhalb des vorhergesagten Bandes</translation>
    </message>
    <message>
        <source>the new gains were not kept</source>
        <translation>die neuen Reglerparameter wurden nicht behalten</translation>
    </message>
    <message>
        <source>the uncertainty of the model allows no motor at all</source>
        <translation>die Unsicherheit des Modells lässt gar keinen Motor zu</translation>
    </message>
    <message>
        <source>identify the motor again</source>
        <translation>den Motor erneut identifizieren</translation>
    </message>
    <message>
        <source>a recorded move of {} s cannot be replayed</source>
        <translation>eine aufgezeichnete Bewegung von {} s lässt sich nicht nachstellen</translation>
    </message>
    <message>
        <source>record {} to {} s of a move</source>
        <translation>{} bis {} s einer Bewegung aufzeichnen</translation>
    </message>
    <message>
        <source>rows are missing at {} s: what happened there is not known</source>
        <translation>bei {} s fehlen Zeilen: Was dort geschah, ist nicht bekannt</translation>
    </message>
    <message>
        <source>record the move again, at 100 Hz or more</source>
        <translation>die Bewegung erneut aufzeichnen, mit 100 Hz oder mehr</translation>
    </message>
    <message>
        <source>the rotor moves already when the recording begins</source>
        <translation>der Rotor bewegt sich schon, wenn die Aufzeichnung beginnt</translation>
    </message>
    <message>
        <source>replay a recording that begins with its move, as `halbench move --out` writes it</source>
        <translation>eine Aufzeichnung nachstellen, die mit ihrer Bewegung beginnt, wie `halbench move --out` sie schreibt</translation>
    </message>
    <message>
        <source>the recording has no {}</source>
        <translation>die Aufzeichnung hat kein {}</translation>
    </message>
    <message>
        <source>a move is replayed from position, reference and current_command</source>
        <translation>eine Bewegung wird aus position, reference und current_command nachgestellt</translation>
    </message>
    <message>
        <source>record the move again</source>
        <translation>die Bewegung erneut aufzeichnen</translation>
    </message>
    <message>
        <source>the identified loop with the gains that ran does not explain the recorded move: {} % of it lie outside the predicted band</source>
        <translation>der identifizierte Kreis mit den Reglerparametern, die liefen, erklärt die aufgezeichnete Bewegung nicht: {} % davon liegen außerhalb des vorhergesagten Bandes</translation>
    </message>
    <message>
        <source>the band is widened until it holds the record; identify the motor anew for a better one</source>
        <translation>das Band ist so verbreitert, dass es die Aufzeichnung enthält; für ein besseres den Motor neu identifizieren</translation>
    </message>
    <message>
        <source>nothing follows from this record for other gains: identify the motor anew, or choose a record of this motor with these gains</source>
        <translation>aus dieser Aufzeichnung folgt nichts für andere Reglerparameter: den Motor neu identifizieren oder eine Aufzeichnung dieses Motors mit diesen Reglerparametern wählen</translation>
    </message>
    <message>
        <source>with these gains the loop is unstable: no motion is predicted</source>
        <translation>mit diesen Reglerparametern ist der Kreis instabil: Es wird keine Bewegung vorhergesagt</translation>
    </message>
    <message>
        <source>choose gains that are stable</source>
        <translation>stabile Reglerparameter wählen</translation>
    </message>
    <message>
        <source>these gains magnify what the model does not know {} times more than those that ran: the band is that much wider</source>
        <translation>diese Reglerparameter vergrößern, was das Modell nicht weiß, {}-mal so sehr wie die, die liefen: Um so viel breiter ist das Band</translation>
    </message>
    <message>
        <source>apply them in small steps, or choose gains with a larger modulus margin</source>
        <translation>sie in kleinen Schritten übernehmen oder Reglerparameter mit größerem Abstand von −1 wählen</translation>
    </message>
    <message>
        <source>name mask, character {}: {}</source>
        <translation>Namensmaske, Zeichen {}: {}</translation>
    </message>
    <message>
        <source>known are {device}, {name}, {date}, {time} and {number}</source>
        <translation>bekannt sind {device}, {name}, {date}, {time} und {number}</translation>
    </message>
    <message>
        <source>a &apos;{&apos; without its &apos;}&apos;</source>
        <translation>ein „{“ ohne sein „}“</translation>
    </message>
    <message>
        <source>there is no placeholder &apos;{}&apos;</source>
        <translation>es gibt keinen Platzhalter „{}“</translation>
    </message>
    <message>
        <source>a &apos;}&apos; without its &apos;{&apos;</source>
        <translation>ein „}“ ohne sein „{“</translation>
    </message>
    <message>
        <source>a name has no folder in it</source>
        <translation>ein Name enthält keinen Ordner</translation>
    </message>
    <message>
        <source>the folder has a field of its own</source>
        <translation>der Ordner hat sein eigenes Feld</translation>
    </message>
    <message>
        <source>file systems refuse &apos;{}&apos;</source>
        <translation>Dateisysteme lehnen „{}“ ab</translation>
    </message>
    <message>
        <source>use letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>verwenden Sie Buchstaben, Ziffern, „-“, „_“ und „.“</translation>
    </message>
    <message>
        <source>a second {number}</source>
        <translation>ein zweites {number}</translation>
    </message>
    <message>
        <source>one number is enough</source>
        <translation>eine Nummer genügt</translation>
    </message>
    <message>
        <source>the name mask is empty</source>
        <translation>die Namensmaske ist leer</translation>
    </message>
    <message>
        <source>write e.g. {}</source>
        <translation>schreiben Sie z. B. {}</translation>
    </message>
    <message>
        <source>a name begins with neither a space nor a point</source>
        <translation>ein Name beginnt weder mit einem Leerzeichen noch mit einem Punkt</translation>
    </message>
    <message>
        <source>begin with a letter</source>
        <translation>beginnen Sie mit einem Buchstaben</translation>
    </message>
    <message>
        <source>the ending is added to the name</source>
        <translation>die Endung wird an den Namen angehängt</translation>
    </message>
    <message>
        <source>leave .csv out</source>
        <translation>lassen Sie .csv weg</translation>
    </message>
    <message>
        <source>the recording&apos;s name would have {} octets</source>
        <translation>der Name der Aufzeichnung hätte {} Oktette</translation>
    </message>
    <message>
        <source>shorten the name or its mask to {} octets</source>
        <translation>kürzen Sie den Namen oder seine Maske auf {} Oktette</translation>
    </message>
    <message>
        <source>say e.g. --retain 30d, --retain 20GB or --retain 30d,20GB</source>
        <translation>schreiben Sie z. B. --retain 30d, --retain 20GB oder --retain 30d,20GB</translation>
    </message>
    <message>
        <source>cannot remove &apos;{}&apos;: {}</source>
        <translation>„{}“ lässt sich nicht entfernen: {}</translation>
    </message>
    <message>
        <source>--retain does not understand &apos;{}&apos;</source>
        <translation>--retain versteht „{}“ nicht</translation>
    </message>
    <message>
        <source>--retain needs a limit</source>
        <translation>--retain braucht eine Grenze</translation>
    </message>
    <message>
        <source>it has tags</source>
        <translation>sie hat Schlagwörter</translation>
    </message>
    <message>
        <source>it has notes</source>
        <translation>sie hat Notizen</translation>
    </message>
    <message>
        <source>a file beside it bears its name</source>
        <translation>eine Datei daneben trägt ihren Namen</translation>
    </message>
    <message>
        <source>it is open</source>
        <translation>sie ist offen</translation>
    </message>
    <message>
        <source>it is of the last 24 hours</source>
        <translation>sie ist aus den letzten 24 Stunden</translation>
    </message>
    <message>
        <source>it is write-protected</source>
        <translation>sie ist schreibgeschützt</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>sie ist ein Verweis</translation>
    </message>
    <message>
        <source>its rows were changed</source>
        <translation>ihre Zeilen wurden geändert</translation>
    </message>
    <message>
        <source>&apos;{}&apos; stays: {}</source>
        <translation>„{}“ bleibt: {}</translation>
    </message>
    <message>
        <source>it is looked at again the next time</source>
        <translation>beim nächsten Mal wird wieder nachgesehen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; of a recording is from 0 to {} s</source>
        <translation>„{}“ einer Aufzeichnung liegt zwischen 0 und {} s</translation>
    </message>
    <message>
        <source>&apos;recording&apos; must be a table</source>
        <translation>„recording“ muss eine Tabelle sein</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; [recording] has before_s, at_trigger, after_s</source>
        <translation>unbekannter Schlüssel „{}“; [recording] hat before_s, at_trigger, after_s</translation>
    </message>
    <message>
        <source>wait longer (--wait; wait_s of a step), or choose another trigger</source>
        <translation>länger warten (--wait; wait_s eines Schritts) oder einen anderen Trigger wählen</translation>
    </message>
    <message>
        <source>holds its position</source>
        <translation>hält die Lage</translation>
    </message>
    <message>
        <source>makes the move</source>
        <translation>führt die Bewegung aus</translation>
    </message>
    <message>
        <source>the trash does not take &apos;{}&apos;</source>
        <translation>der Papierkorb nimmt „{}“ nicht</translation>
    </message>
    <message>
        <source>empty the trash; where a disk has none, `halbench recordings --retain ... --delete` deletes for good</source>
        <translation>Leeren Sie den Papierkorb; wo ein Datenträger keinen hat, löscht `halbench recordings --retain ... --delete` endgültig</translation>
    </message>
    <message>
        <source>least integral of the absolute error after a load, with Ms and current within bounds</source>
        <translation>kleinstes Integral des Fehlerbetrags nach einer Last, Ms und Strom in Grenzen</translation>
    </message>
    <message>
        <source>the target {} = {} is not between {} and {}</source>
        <translation>das Ziel {} = {} liegt nicht zwischen {} und {}</translation>
    </message>
    <message>
        <source>1.4 is calm, 1.7 usual, 2 lively</source>
        <translation>1,4 ist ruhig, 1,7 üblich, 2 lebhaft</translation>
    </message>
    <message>
        <source>give the current that the motor can take, in A</source>
        <translation>den Strom angeben, den der Motor verträgt, in A</translation>
    </message>
    <message>
        <source>give the largest step that shall not saturate, in degrees</source>
        <translation>den größten Sprung angeben, der die Stromgrenze nicht erreichen soll, in Grad</translation>
    </message>
    <message>
        <source>the target step-deg needs the target current-limit-a</source>
        <translation>das Ziel step-deg braucht das Ziel current-limit-a</translation>
    </message>
    <message>
        <source>say how much current that step may ask for</source>
        <translation>angeben, wie viel Strom dieser Sprung verlangen darf</translation>
    </message>
    <message>
        <source>no gains with a peak of sensitivity up to {} were found for this motor: the calmest loop has {}</source>
        <translation>für diesen Motor wurden keine Reglerparameter mit einer Empfindlichkeitsspitze bis {} gefunden: Der ruhigste Kreis hat {}</translation>
    </message>
    <message>
        <source>no gains that ask for {} A at most in a step of {} deg were found for this motor: {} A are needed</source>
        <translation>für diesen Motor wurden keine Reglerparameter gefunden, die höchstens {} A bei einem Sprung von {} Grad verlangen: {} A sind nötig</translation>
    </message>
    <message>
        <source>allow more current, or a smaller step</source>
        <translation>mehr Strom oder einen kleineren Sprung zulassen</translation>
    </message>
    <message>
        <source>the target current-limit-a = {} is above the board&apos;s own limit of {} A</source>
        <translation>das Ziel current-limit-a = {} liegt über der eigenen Grenze des Steuergeräts von {} A</translation>
    </message>
    <message>
        <source>choose up to that, or leave it out</source>
        <translation>bis dahin wählen oder weglassen</translation>
    </message>
    <message>
        <source>any motion</source>
        <translation>jede Bewegung</translation>
    </message>
    <message>
        <source>a swing beyond +-{} deg</source>
        <translation>eine Schwingung über +-{} deg</translation>
    </message>
    <message>
        <source>{} grows into a lasting one of about +-{} deg at {} Hz</source>
        <translation>{} wächst zu einer dauernden von etwa +-{} deg bei {} Hz</translation>
    </message>
    <message>
        <source>keep to small steps, or choose a smaller K_P</source>
        <translation>nur kleine Sprünge fahren, oder K_P kleiner wählen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot name a signal: it is the time</source>
        <translation>&apos;{}&apos; kann kein Signal bezeichnen: Das ist die Zeit</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot name a signal</source>
        <translation>&apos;{}&apos; kann kein Signal bezeichnen</translation>
    </message>
    <message>
        <source>a name has letters, digits, &apos;.&apos; and &apos;_&apos; and begins with a letter</source>
        <translation>ein Name besteht aus Buchstaben, Ziffern, &apos;.&apos; und &apos;_&apos; und beginnt mit einem Buchstaben</translation>
    </message>
    <message>
        <source>the name &apos;{}&apos; is given to two columns</source>
        <translation>den Namen &apos;{}&apos; bekommen zwei Spalten</translation>
    </message>
    <message>
        <source>give every column a name of its own</source>
        <translation>geben Sie jeder Spalte einen eigenen Namen</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is given two names</source>
        <translation>die Spalte &apos;{}&apos; bekommt zwei Namen</translation>
    </message>
    <message>
        <source>give every column one name</source>
        <translation>geben Sie jeder Spalte einen Namen</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is the time and cannot be called &apos;{}&apos;</source>
        <translation>die Spalte &apos;{}&apos; ist die Zeit und kann nicht &apos;{}&apos; heißen</translation>
    </message>
    <message>
        <source>the ultimate gain and the ultimate period belong together</source>
        <translation>kritische Verstärkung und kritische Periode gehören zusammen</translation>
    </message>
    <message>
        <source>give both, as the relay experiment found them, or leave both to the model</source>
        <translation>geben Sie beide an, wie der Relaisversuch sie gefunden hat, oder überlassen Sie beide dem Modell</translation>
    </message>
    <message>
        <source>the rows of the cycle are not three signals of one length</source>
        <translation>die Zeilen der Schwingung sind nicht drei gleich lange Signale</translation>
    </message>
    <message>
        <source>a row of the cycle holds no number</source>
        <translation>eine Zeile der Schwingung enthält keine Zahl</translation>
    </message>
    <message>
        <source>no rotor has the response that the cycle shows</source>
        <translation>kein Rotor antwortet so, wie die Schwingung es zeigt</translation>
    </message>
    <message>
        <source>look at the record: an angle error or a resonance may be in it</source>
        <translation>sehen Sie sich die Aufzeichnung an: darin kann ein Winkelfehler oder eine Resonanz stecken</translation>
    </message>
    <message>
        <source>the loop swings {} times in the record: that is no limit cycle</source>
        <translation>der Kreis schwingt in der Aufzeichnung {}-mal: das ist keine Dauerschwingung</translation>
    </message>
    <message>
        <source>use a larger gain of the relay, or the model of this motor</source>
        <translation>verwenden Sie eine größere Verstärkung des Relais oder das Modell dieses Motors</translation>
    </message>
    <message>
        <source>this motor does not damp: proportional control swings at any gain</source>
        <translation>dieser Motor dämpft nicht: mit P-Regelung schwingt er bei jeder Verstärkung</translation>
    </message>
    <message>
        <source>there is no ultimate gain; use a method with derivative action</source>
        <translation>es gibt keine kritische Verstärkung; verwenden Sie ein Verfahren mit D-Anteil</translation>
    </message>
    <message>
        <source>at the cycle&apos;s frequency the phase is {} deg, too far from -180 deg</source>
        <translation>bei der Frequenz der Schwingung ist die Phase {} Grad, zu weit von -180 Grad entfernt</translation>
    </message>
    <message>
        <source>at most {} deg are allowed: look for a delay that the board does not tell, or a resonance</source>
        <translation>höchstens {} Grad sind erlaubt: suchen Sie nach einer Verzögerung, die das Steuergerät nicht angibt, oder nach einer Resonanz</translation>
    </message>
    <message>
        <source>rows are missing: the cycles do not fit together</source>
        <translation>Zeilen fehlen: die Schwingungen passen nicht zusammen</translation>
    </message>
    <message>
        <source>the cycle&apos;s frequency wanders by {} %: the angle&apos;s errors drive it with the turn, {} % are allowed</source>
        <translation>die Frequenz der Schwingung wandert um {} %: die Winkelfehler treiben sie mit der Umdrehung an, {} % sind erlaubt</translation>
    </message>
    <message>
        <source>calibrate the sensors and apply it, then measure again</source>
        <translation>kalibrieren Sie die Sensoren, übernehmen Sie das, und messen Sie erneut</translation>
    </message>
    <message>
        <source>the cycle&apos;s amplitude changes by {} % from the first third to the last</source>
        <translation>die Amplitude der Schwingung ändert sich vom ersten bis zum letzten Drittel um {} %</translation>
    </message>
    <message>
        <source>measure more cycles, or give the relay a larger gain; calibrate the sensors first</source>
        <translation>messen Sie mehr Schwingungen, oder geben Sie dem Relais eine größere Verstärkung; kalibrieren Sie zuerst die Sensoren</translation>
    </message>
    <message>
        <source>the ultimate gain lies between {} and {} A/rad: that is no answer</source>
        <translation>die kritische Verstärkung liegt zwischen {} und {} A/rad: das ist keine Antwort</translation>
    </message>
    <message>
        <source>measure more cycles; calibrate the sensors first</source>
        <translation>messen Sie mehr Schwingungen; kalibrieren Sie zuerst die Sensoren</translation>
    </message>
    <message>
        <source>the ultimate gain is known to {} % only</source>
        <translation>die kritische Verstärkung ist nur auf {} % bekannt</translation>
    </message>
    <message>
        <source>the model foresees an ultimate gain of {} to {} A/rad, measured were {} to {}</source>
        <translation>das Modell sieht eine kritische Verstärkung von {} bis {} A/rad voraus, gemessen wurden {} bis {}</translation>
    </message>
    <message>
        <source>identify the motor again: it has changed, or one of the two is wrong</source>
        <translation>identifizieren Sie den Motor erneut: er hat sich verändert, oder eines von beiden ist falsch</translation>
    </message>
    <message>
        <source>whether it agrees with the model is not known: the model has no covariance</source>
        <translation>ob es mit dem Modell übereinstimmt, ist nicht bekannt: das Modell hat keine Kovarianz</translation>
    </message>
    <message>
        <source>it was compared with no model of this motor</source>
        <translation>es wurde mit keinem Modell dieses Motors verglichen</translation>
    </message>
    <message>
        <source>identify the motor and give its model</source>
        <translation>identifizieren Sie den Motor, und geben Sie sein Modell an</translation>
    </message>
    <message>
        <source>speed limit in rad/s</source>
        <translation>Drehzahlgrenze in rad/s</translation>
    </message>
    <message>
        <source>number of cycles</source>
        <translation>Anzahl der Schwingungen</translation>
    </message>
    <message>
        <source>height of the relay in A</source>
        <translation>Höhe des Relais in A</translation>
    </message>
    <message>
        <source>gain of the relay in A/rad</source>
        <translation>Verstärkung des Relais in A/rad</translation>
    </message>
    <message>
        <source>on a base of {} rad/s no relay swings the loop by {} rad without bringing the rotor near standstill or above {} rad/s</source>
        <translation>bei einer Grunddrehzahl von {} rad/s schwingt kein Relais den Kreis um {} rad, ohne den Rotor dem Stillstand nahe oder über {} rad/s zu bringen</translation>
    </message>
    <message>
        <source>no base speed from {} to {} rad/s lets a relay swing the loop by {} rad without bringing the rotor near standstill</source>
        <translation>keine Grunddrehzahl von {} bis {} rad/s lässt ein Relais den Kreis um {} rad schwingen, ohne den Rotor dem Stillstand nahe zu bringen</translation>
    </message>
    <message>
        <source>leave base speed and height of the relay to the program, allow a higher speed or more current, or use the model of this motor</source>
        <translation>überlassen Sie Grunddrehzahl und Höhe des Relais dem Programm, erlauben Sie eine höhere Drehzahl oder mehr Strom, oder verwenden Sie das Modell dieses Motors</translation>
    </message>
    <message>
        <source>calibrate the sensors and apply it, use the model of this motor, or a lower relay</source>
        <translation>kalibrieren Sie die Sensoren und übernehmen Sie das, verwenden Sie das Modell dieses Motors oder ein niedrigeres Relais</translation>
    </message>
    <message>
        <source>the rotor reached {} rad/s, foreseen were {}</source>
        <translation>der Rotor erreichte {} rad/s, vorhergesehen waren {}</translation>
    </message>
    <message>
        <source>identify the motor and give its model: the plan was made for another one</source>
        <translation>identifizieren Sie den Motor, und geben Sie sein Modell an: der Plan war für einen anderen</translation>
    </message>
    <message>
        <source>swings around a steady motion</source>
        <translation>schwingt um eine gleichmäßige Bewegung</translation>
    </message>
    <message>
        <source>the device has no parameter for {}</source>
        <translation>das Gerät hat keinen Parameter für {}</translation>
    </message>
    <message>
        <source>the relay experiment needs a position loop with a gain and a current limit</source>
        <translation>der Relaisversuch braucht einen Lageregelkreis mit einer Verstärkung und einer Stromgrenze</translation>
    </message>
    <message>
        <source>the clock is in doubt</source>
        <translation>die Uhr ist zweifelhaft</translation>
    </message>
    <message>
        <source>{}: which gains ran is not recorded beside it</source>
        <translation>{}: Welche Reglerparameter liefen, ist nicht daneben aufgezeichnet</translation>
    </message>
    <message>
        <source>{}: {} was changed at {} s of the recording</source>
        <translation>{}: {} wurde bei {} s der Aufzeichnung geändert</translation>
    </message>
    <message>
        <source>record a move under one set of gains</source>
        <translation>eine Bewegung mit einem einzigen Satz Reglerparameter aufzeichnen</translation>
    </message>
    <message>
        <source>{}: the gains that ran are of another sample period</source>
        <translation>{}: Die Reglerparameter, die liefen, haben eine andere Abtastzeit</translation>
    </message>
    <message>
        <source>compare gains of one board</source>
        <translation>Reglerparameter eines einzigen Steuergeräts vergleichen</translation>
    </message>
    <message>
        <source>the gains were found for the {} &apos;{}&apos;, this device is the {} &apos;{}&apos;</source>
        <translation>die Reglerparameter wurden für {} „{}“ gefunden, dieses Gerät ist {} „{}“</translation>
    </message>
    <message>
        <source>the gains were found for &apos;{}&apos; with other overrides than this device has</source>
        <translation>die Reglerparameter wurden für „{}“ mit anderen Abweichungen gefunden, als dieses Gerät sie hat</translation>
    </message>
    <message>
        <source>the gains are for {} s with {} samples of delay, this device has {} s and {}: they are judged as they would run on it</source>
        <translation>die Reglerparameter sind für {} s mit {} Abtastungen Totzeit, dieses Gerät hat {} s und {}: sie werden beurteilt, wie sie auf ihm liefen</translation>
    </message>
    <message>
        <source>design them for the timing of this device</source>
        <translation>entwerfen Sie sie für die Abtastung dieses Geräts</translation>
    </message>
    <message>
        <source>{}; nothing was written</source>
        <translation>{}; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>these gains are refused; nothing was written</source>
        <translation>diese Reglerparameter sind abgelehnt; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>see their findings</source>
        <translation>siehe ihre Befunde</translation>
    </message>
    <message>
        <source>{} signals cannot come at {} Hz: board and link carry at most {} Hz</source>
        <translation>{} Signale können nicht mit {} Hz kommen: Steuergerät und Verbindung tragen höchstens {} Hz</translation>
    </message>
    <message>
        <source>take a lower rate or fewer signals; a port that is USB all the way to the board is faster than its baud rate: say so in its address with ?baud=12000000</source>
        <translation>nehmen Sie eine kleinere Rate oder weniger Signale; ein Anschluss, der bis ins Steuergerät USB ist, ist schneller als seine Baudrate: sagen Sie es in seiner Adresse mit ?baud=12000000</translation>
    </message>
    <message>
        <source>take a lower rate or fewer signals</source>
        <translation>nehmen Sie eine kleinere Rate oder weniger Signale</translation>
    </message>
    <message>
        <source>[monitor] has follow and cursors (true or false), span_s, rate_hz and trigger</source>
        <translation>[monitor] hat follow und cursors (true oder false), span_s, rate_hz und trigger</translation>
    </message>
    <message>
        <source>&apos;rate_hz&apos; must not be negative</source>
        <translation>„rate_hz“ darf nicht negativ sein</translation>
    </message>
    <message>
        <source>must be &quot;parallel&quot;, &quot;standard&quot; or &quot;series&quot;</source>
        <translation>muss „parallel“, „standard“ oder „series“ sein</translation>
    </message>
    <message>
        <source>{}: gains.filter_s: {}</source>
        <translation>{}: gains.filter_s: {}</translation>
    </message>
    <message>
        <source>{}: gains: {}</source>
        <translation>{}: gains: {}</translation>
    </message>
    <message>
        <source>is nothing that the board&apos;s law has</source>
        <translation>gibt es im Regelgesetz des Steuergeräts nicht</translation>
    </message>
    <message>
        <source>a band under a load of {} A is not possible</source>
        <translation>ein Band unter einer Last von {} A ist nicht möglich</translation>
    </message>
    <message>
        <source>another program changes &apos;{}&apos;</source>
        <translation>ein anderes Programm ändert „{}“</translation>
    </message>
    <message>
        <source>only recordings with their sidecar keep markers that are changed later</source>
        <translation>nur Aufzeichnungen mit ihrer Begleitdatei behalten später geänderte Marken</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; known are schema, device, notes, perspective, layout, monitor, monitor2, monitor3, recording, plot, cursors, derived, given, model, design, calibration</source>
        <translation>unbekannter Schlüssel „{}“; bekannt sind schema, device, notes, perspective, layout, monitor, monitor2, monitor3, recording, plot, cursors, derived, given, model, design, calibration</translation>
    </message>
    <message>
        <source>a set-point weight is not a finite number</source>
        <translation>ein Sollwertgewicht ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the set-point weight {} = {} is not between 0 and 1</source>
        <translation>das Sollwertgewicht {} = {} liegt nicht zwischen 0 und 1</translation>
    </message>
    <message>
        <source>without integral action the set-point weight b = {} leaves the motor at {} times its reference</source>
        <translation>ohne Integralanteil bleibt der Motor mit dem Sollwertgewicht b = {} beim {}-Fachen des Sollwerts stehen</translation>
    </message>
    <message>
        <source>add integral action, or leave b at 1</source>
        <translation>Integralanteil hinzunehmen oder b bei 1 lassen</translation>
    </message>
    <message>
        <source>{} filters are more than {}</source>
        <translation>{} Filter sind mehr als {}</translation>
    </message>
    <message>
        <source>&apos;units&apos; must be a table of signals with their units, units.position = &quot;mrad&quot;</source>
        <translation>„units“ muss eine Tabelle von Signalen mit ihren Einheiten sein, units.position = &quot;mrad&quot;</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no unit that a signal is shown in; there are {}</source>
        <translation>„{}“ ist keine Einheit, in der ein Signal gezeigt wird; es gibt {}</translation>
    </message>
    <message>
        <source>&apos;units&apos; names &apos;{}&apos;, which this [[plot]] does not show</source>
        <translation>„units“ nennt „{}“, was dieses [[plot]] nicht zeigt</translation>
    </message>
    <message>
        <source>leave it out to use these gains; weights and filters are judged by &apos;halbench analyse&apos; and &apos;halbench tune --gains&apos;</source>
        <translation>lassen Sie es weg, um diese Verstärkungen zu verwenden; Gewichte und Filter beurteilen &apos;halbench analyse&apos; und &apos;halbench tune --gains&apos;</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a whole number from 1 to {}</source>
        <translation>„{}“ muss eine ganze Zahl von 1 bis {} sein</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a [[plot]] has signals, min, max, unit, right, right_min, right_max, right_unit, own_span_s, own_follow, column, height_percent, width_percent, units</source>
        <translation>unbekannter Schlüssel „{}“; ein [[plot]] hat signals, min, max, unit, right, right_min, right_max, right_unit, own_span_s, own_follow, column, height_percent, width_percent, units</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was changed since it was recorded: {} of {} rows</source>
        <translation>„{}“ wurde seit der Aufzeichnung geändert: {} von {} Zeilen</translation>
    </message>
    <message>
        <source>one signal cannot come at {} Hz: board and link carry at most {} Hz</source>
        <translation>ein Signal kann nicht mit {} Hz kommen: Steuergerät und Verbindung tragen höchstens {} Hz</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a device or pipe</source>
        <translation>„{}“ ist ein Gerät oder eine Pipe</translation>
    </message>
    <message>
        <source>no row of &apos;{}&apos; is undamaged</source>
        <translation>keine Zeile von „{}“ ist unbeschädigt</translation>
    </message>
    <message>
        <source>it stays as it is: what is in it can be read as text</source>
        <translation>sie bleibt, wie sie ist: ihr Inhalt ist als Text lesbar</translation>
    </message>
    <message>
        <source>it stays as it is; to read what its checksums do not confirm, move &apos;{}&apos; away</source>
        <translation>sie bleibt, wie sie ist; um zu lesen, was ihre Prüfsummen nicht bestätigen, verschieben Sie „{}“</translation>
    </message>
    <message>
        <source>a step of {} s is not simulated with a sampling period of {} s</source>
        <translation>ein Sprung von {} s wird mit einer Abtastzeit von {} s nicht simuliert</translation>
    </message>
    <message>
        <source>give a period of {} s or more</source>
        <translation>eine Abtastzeit von {} s oder mehr angeben</translation>
    </message>
    <message>
        <source>a recorded move has rows of 1 ms and cannot be replayed through a loop of {} ms</source>
        <translation>eine aufgenommene Bewegung hat Zeilen von 1 ms und lässt sich nicht durch einen Regelkreis von {} ms wiedergeben</translation>
    </message>
    <message>
        <source>what if needs a sampling period of whole milliseconds</source>
        <translation>„Was wäre wenn“ braucht eine Abtastzeit von ganzen Millisekunden</translation>
    </message>
    <message>
        <source>the step has no figures: its slowest part decays by {} in a sample, far longer than what is simulated</source>
        <translation>der Sprung hat keine Kennwerte: sein langsamster Teil klingt je Abtastschritt um {} ab, weit länger als simuliert wird</translation>
    </message>
    <message>
        <source>choose gains with faster poles, or a longer sampling period</source>
        <translation>Parameter mit schnelleren Polen oder eine längere Abtastzeit wählen</translation>
    </message>
    <message>
        <source>with friction and the current limit a step of {} deg is not there after {} s: how far it overshoots is not known</source>
        <translation>mit Reibung und Stromgrenze ist ein Sprung von {} deg nach {} s nicht da: wie weit er überschwingt, ist nicht bekannt</translation>
    </message>
    <message>
        <source>choose a faster loop, or one with more integral action</source>
        <translation>einen schnelleren Kreis wählen oder einen mit mehr I-Anteil</translation>
    </message>
    <message>
        <source>must be a positive time in seconds</source>
        <translation>muss eine positive Zeit in Sekunden sein</translation>
    </message>
    <message>
        <source>the motor was measured at {} s with {} samples of delay, this device has {} s and {}</source>
        <translation>der Motor wurde mit {} s und {} Abtastungen Verzögerung gemessen, dieses Gerät hat {} s und {}</translation>
    </message>
    <message>
        <source>identify the motor with the delay that this device has now</source>
        <translation>den Motor mit der Verzögerung identifizieren, die dieses Gerät jetzt hat</translation>
    </message>
    <message>
        <source>wrong sign of current or angle: the current accelerates the rotor backwards, its torque constant would be negative</source>
        <translation>falsches Vorzeichen von Strom oder Winkel: der Strom beschleunigt den Rotor rückwärts, seine Drehmomentkonstante wäre negativ</translation>
    </message>
    <message>
        <source>turn the sign of one of the two on the board and measure again</source>
        <translation>drehen Sie am Steuergerät eines der beiden Vorzeichen um und messen Sie erneut</translation>
    </message>
    <message>
        <source>the interval of phi/J reaches zero</source>
        <translation>das Intervall von phi/J reicht bis null</translation>
    </message>
    <message>
        <source>a damping below zero came out, which no motor has</source>
        <translation>es ergab sich eine Dämpfung unter null, die kein Motor hat</translation>
    </message>
    <message>
        <source>check the delay of the loop, and that nothing else drives the rotor</source>
        <translation>prüfen Sie die Totzeit des Regelkreises und dass nichts anderes den Rotor antreibt</translation>
    </message>
    <message>
        <source>turns against its current</source>
        <translation>dreht gegen seinen Strom</translation>
    </message>
    <message>
        <source>wrong sign of current or angle: {}</source>
        <translation>falsches Vorzeichen von Strom oder Winkel: {}</translation>
    </message>
    <message>
        <source>turn the sign of one of the two columns (or of the command on the board) and identify again</source>
        <translation>drehen Sie das Vorzeichen einer der beiden Spalten (oder des Befehls am Steuergerät) um und identifizieren Sie erneut</translation>
    </message>
    <message>
        <source>a friction below zero came out, which no motor has</source>
        <translation>es ergab sich eine Reibung unter null, die kein Motor hat</translation>
    </message>
    <message>
        <source>friction cannot be told from zero: it is at most {} % of the torque</source>
        <translation>Reibung ist von null nicht zu unterscheiden: sie beträgt höchstens {} % des Drehmoments</translation>
    </message>
    <message>
        <source>friction is undecided: between zero and {} % of the largest torque</source>
        <translation>Reibung ist unbestimmt: zwischen null und {} % des größten Drehmoments</translation>
    </message>
    <message>
        <source>damping cannot be told from zero: it is at most {} % of the torque</source>
        <translation>Dämpfung ist von null nicht zu unterscheiden: sie beträgt höchstens {} % des Drehmoments</translation>
    </message>
    <message>
        <source>damping is undecided: between zero and {} % of the largest torque</source>
        <translation>Dämpfung ist unbestimmt: zwischen null und {} % des größten Drehmoments</translation>
    </message>
    <message>
        <source>current and angle do not belong together: check their units, that no column is shifted in time, and that nothing else drives the rotor</source>
        <translation>Strom und Winkel gehören nicht zusammen: prüfen Sie ihre Einheiten, dass keine Spalte zeitlich verschoben ist und dass nichts anderes den Rotor antreibt</translation>
    </message>
    <message>
        <source>record more run-ups and coast-downs, over a wider range of speed</source>
        <translation>zeichnen Sie mehr Hochläufe und Ausläufe über einen größeren Drehzahlbereich auf</translation>
    </message>
    <message>
        <source>the value is zero and its interval begins there</source>
        <translation>der Wert ist null, und dort beginnt sein Intervall</translation>
    </message>
    <message>
        <source>the current accelerates the rotor backwards, its torque constant would be negative</source>
        <translation>der Strom beschleunigt den Rotor rückwärts, seine Drehmomentkonstante wäre negativ</translation>
    </message>
    <message>
        <source>an inertia below zero came out, which no rotor has</source>
        <translation>es ergab sich eine Trägheit unter null, die kein Rotor hat</translation>
    </message>
    <message>
        <source>check the given constants, and the units of current and angle</source>
        <translation>prüfen Sie die angegebenen Konstanten und die Einheiten von Strom und Winkel</translation>
    </message>
    <message>
        <source>the interval of the torque constant or of the inertia reaches zero</source>
        <translation>das Intervall der Drehmomentkonstante oder der Trägheit reicht bis null</translation>
    </message>
    <message>
        <source>use larger and more different currents, and hold each longer</source>
        <translation>verwenden Sie größere und stärker verschiedene Ströme und halten Sie jeden länger</translation>
    </message>
    <message>
        <source>the angle&apos;s column looks like a speed: it settles with each current instead of growing on</source>
        <translation>die Spalte des Winkels sieht wie eine Drehzahl aus: sie läuft bei jedem Strom auf einen Wert ein, statt weiterzuwachsen</translation>
    </message>
    <message>
        <source>record the position, or rename the columns</source>
        <translation>zeichnen Sie die Position auf oder benennen Sie die Spalten um</translation>
    </message>
    <message>
        <source>the angle wraps after {} deg: it was continued</source>
        <translation>der Winkel springt nach {} Grad zurück: er wurde fortgesetzt</translation>
    </message>
    <message>
        <source>nothing is lost as long as the rotor turns less than half of that between two rows</source>
        <translation>nichts geht verloren, solange der Rotor zwischen zwei Zeilen weniger als die Hälfte davon dreht</translation>
    </message>
    <message>
        <source>the rotor turns against its current</source>
        <translation>der Rotor dreht gegen seinen Strom</translation>
    </message>
    <message>
        <source>the board&apos;s clock started again: the recording has a gap there, as long as this computer&apos;s clock says</source>
        <translation>die Uhr des Steuergeräts begann neu: dort hat die Aufzeichnung eine Lücke, so lang wie nach der Uhr dieses Rechners</translation>
    </message>
    <message>
        <source>the line damaged {} % of the frames</source>
        <translation>die Leitung beschädigte {} % der Rahmen</translation>
    </message>
    <message>
        <source>shorten or shield the cable, or lower the baud rate</source>
        <translation>kürzen oder schirmen Sie das Kabel, oder senken Sie die Baudrate</translation>
    </message>
    <message>
        <source>{} % of the packets were lost and none was damaged: a queue was full</source>
        <translation>{} % der Pakete gingen verloren und keines war beschädigt: eine Warteschlange war voll</translation>
    </message>
    <message>
        <source>record fewer signals or at a lower rate, or connect by tcp: instead of udp:</source>
        <translation>zeichnen Sie weniger Signale oder mit kleinerer Rate auf, oder verbinden Sie über tcp: statt udp:</translation>
    </message>
    <message>
        <source>no packet was lost or damaged: the board left rows out or sent them late</source>
        <translation>kein Paket ging verloren oder wurde beschädigt: das Steuergerät ließ Zeilen aus oder sandte sie zu spät</translation>
    </message>
    <message>
        <source>record again; at most one row in ten may be lost</source>
        <translation>zeichnen Sie neu auf; höchstens eine von zehn Zeilen darf fehlen</translation>
    </message>
    <message>
        <source>measure again</source>
        <translation>messen Sie noch einmal</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>A number of the spherical rotor is not finite.</source>
        <translation>Eine Zahl des kugelförmigen Läufers ist nicht endlich.</translation>
    </message>
    <message>
        <source>The outer radius of the magnet must be larger than the radius of its core.</source>
        <translation>Der Außenradius des Magneten muss größer sein als der Radius seines Kerns.</translation>
    </message>
    <message>
        <source>Relative permeabilities of the rotor are at least 1.</source>
        <translation>Relative Permeabilitäten des Läufers sind mindestens 1.</translation>
    </message>
    <message>
        <source>The amplitude of a spherical harmonic is not a finite number.</source>
        <translation>Die Amplitude einer Kugelflächenfunktion ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>A spherical harmonic needs a degree of 1 to 16 and an order of 0 to its degree.</source>
        <translation>Eine Kugelflächenfunktion braucht einen Grad von 1 bis 16 und eine Ordnung von 0 bis zu ihrem Grad.</translation>
    </message>
    <message>
        <source>A number of the stator coil is not finite.</source>
        <translation>Eine Zahl der Statorspule ist nicht endlich.</translation>
    </message>
    <message>
        <source>A stator coil needs a positive radius, turns and an axis of length one.</source>
        <translation>Eine Statorspule braucht einen positiven Radius, Windungen und eine Achse der Länge eins.</translation>
    </message>
    <message>
        <source>A field sensor setting is not a finite number.</source>
        <translation>Eine Einstellung des Feldsensors ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>A field sensor needs positive gains, noise of at least zero and a range of at least two steps of its converter.</source>
        <translation>Ein Feldsensor braucht positive Verstärkungen, ein Rauschen von mindestens null und einen Bereich von mindestens zwei Stufen seines Wandlers.</translation>
    </message>
    <message>
        <source>The pose of a field sensor is not a finite number.</source>
        <translation>Die Lage eines Feldsensors ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>A field sensor lies inside the rotor.</source>
        <translation>Ein Feldsensor liegt im Läufer.</translation>
    </message>
    <message>
        <source>Place it outside the rotor&apos;s outer radius.</source>
        <translation>Setzen Sie ihn außerhalb des Außenradius des Läufers.</translation>
    </message>
    <message>
        <source>The three axes of a field sensor must be unit vectors that span the space.</source>
        <translation>Die drei Achsen eines Feldsensors müssen Einheitsvektoren sein, die den Raum aufspannen.</translation>
    </message>
    <message>
        <source>Two field sensors lie at the same place.</source>
        <translation>Zwei Feldsensoren liegen an derselben Stelle.</translation>
    </message>
    <message>
        <source>Each of the three sensors needs a place of its own.</source>
        <translation>Jeder der drei Sensoren braucht eine eigene Stelle.</translation>
    </message>
    <message>
        <source>settling: the speed that it approaches</source>
        <translation>einschwingend: die Drehzahl, der er sich nähert</translation>
    </message>
    <message>
        <source>there are no more stretches of motion than unknowns: how much friction differs between them is assumed, 3.3 % of its torque, and not measured</source>
        <translation>es gibt nicht mehr Bewegungsabschnitte als Unbekannte: wie stark sich die Reibung zwischen ihnen unterscheidet, ist mit 3,3 % ihres Moments angenommen und nicht gemessen</translation>
    </message>
    <message>
        <source>record more run-ups and coast-downs at different currents, in both directions</source>
        <translation>zeichnen Sie mehr Hoch- und Ausläufe mit verschiedenen Strömen auf, in beiden Richtungen</translation>
    </message>
    <message>
        <source>the cycle shows a damping below zero, which no motor has</source>
        <translation>die Schwingung zeigt eine Dämpfung unter null, die kein Motor hat</translation>
    </message>
    <message>
        <source>calibrate the sensors; look for a delay that the board does not tell</source>
        <translation>kalibrieren Sie die Sensoren; suchen Sie eine Totzeit, die das Steuergerät nicht nennt</translation>
    </message>
    <message>
        <source>the intervals do not hold that error: use the speeds that matter, warm the bearings up first, and look at the residuals</source>
        <translation>die Intervalle enthalten diesen Fehler nicht: nutzen Sie die Drehzahlen, auf die es ankommt, lassen Sie die Lager erst warm laufen und sehen Sie sich die Residuen an</translation>
    </message>
    <message>
        <source>drag grows with the square of the speed, by {}</source>
        <translation>der Widerstand wächst mit dem Quadrat der Drehzahl, um {}</translation>
    </message>
    <message>
        <source>c, K_f and phi are those beside this term; the model that is used for tuning has no such drag</source>
        <translation>c, K_f und phi gelten neben diesem Term; das Modell für die Einstellung hat keinen solchen Widerstand</translation>
    </message>
    <message>
        <source>friction falls with the speed (Stribeck): at {} rad/s it is higher by {}, above about {} rad/s it is constant</source>
        <translation>die Reibung fällt mit der Drehzahl (Stribeck): bei {} rad/s ist sie um {} höher, über etwa {} rad/s ist sie konstant</translation>
    </message>
    <message>
        <source>c, K_f and phi are those beside this term, at high speed; near standstill friction is higher</source>
        <translation>c, K_f und phi gelten neben diesem Term, bei hoher Drehzahl; nahe dem Stillstand ist die Reibung höher</translation>
    </message>
    <message>
        <source>model inadequate: the damping differs between the directions</source>
        <translation>Modell unzureichend: die Dämpfung unterscheidet sich zwischen den Richtungen</translation>
    </message>
    <message>
        <source>the damping changes with the current: the angle of the torque moves with it, as a wrong compensation of the stray field moves it</source>
        <translation>die Dämpfung ändert sich mit dem Strom: der Winkel des Drehmoments wandert mit ihm, wie ihn eine falsche Kompensation des Streufelds verschiebt</translation>
    </message>
    <message>
        <source>phi is smaller than the true one by up to some per cent: calibrate the stray field, then identify again</source>
        <translation>phi ist um bis zu einige Prozent kleiner als in Wahrheit: kalibrieren Sie das Streufeld und identifizieren Sie dann erneut</translation>
    </message>
    <message>
        <source>model inadequate: the damping changes in the course of the recording</source>
        <translation>Modell unzureichend: die Dämpfung ändert sich im Lauf der Aufzeichnung</translation>
    </message>
    <message>
        <source>model inadequate: friction depends on the speed as no known law does</source>
        <translation>Modell unzureichend: die Reibung hängt von der Drehzahl ab wie nach keinem bekannten Gesetz</translation>
    </message>
    <message>
        <source>the motion does not tell the forces apart</source>
        <translation>die Bewegung unterscheidet die Kräfte nicht</translation>
    </message>
    <message>
        <source>a coefficient of a filter is not a finite number</source>
        <translation>ein Koeffizient eines Filters ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the filter with a1 = {}, a2 = {} is not stable</source>
        <translation>das Filter mit a1 = {}, a2 = {} ist nicht stabil</translation>
    </message>
    <message>
        <source>a section is given as it is sampled</source>
        <translation>ein Glied 2. Ordnung wird in abgetasteter Form angegeben</translation>
    </message>
    <message>
        <source>A number of the grid of poses is not finite.</source>
        <translation>Eine Zahl des Posengitters ist nicht endlich.</translation>
    </message>
    <message>
        <source>The grid of poses is empty.</source>
        <translation>Das Posengitter ist leer.</translation>
    </message>
    <message>
        <source>The grid has more than 200 million poses.</source>
        <translation>Das Gitter hat mehr als 200 Millionen Posen.</translation>
    </message>
    <message>
        <source>Make its step larger.</source>
        <translation>Vergrößern Sie seine Schrittweite.</translation>
    </message>
    <message>
        <source>The proof of the coverage was stopped.</source>
        <translation>Der Nachweis der Abdeckung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The box of the coverage proof is empty or its cells too small.</source>
        <translation>Der Bereich des Abdeckungsnachweises ist leer, oder seine Zellen sind zu klein.</translation>
    </message>
    <message>
        <source>The claimed placement is not on the lattice.</source>
        <translation>Die angegebene Anordnung liegt nicht auf dem Gitter.</translation>
    </message>
    <message>
        <source>The estimator needs harmonic passes of at least 0, at least one iteration and a positive limit of chi-square.</source>
        <translation>Der Schätzer braucht mindestens 0 Durchgänge für die Kugelflächenfunktionen, mindestens eine Iteration und eine positive Grenze für Chi-Quadrat.</translation>
    </message>
    <message>
        <source>The sensors do not determine the field of the rotor.</source>
        <translation>Die Sensoren bestimmen das Feld des Läufers nicht.</translation>
    </message>
    <message>
        <source>Two of them need directions that differ and are not opposite.</source>
        <translation>Zwei von ihnen brauchen Richtungen, die verschieden und nicht entgegengesetzt sind.</translation>
    </message>
    <message>
        <source>The computation was stopped.</source>
        <translation>Die Berechnung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>A number of the rotor&apos;s motion is not finite.</source>
        <translation>Eine Zahl der Läuferbewegung ist nicht endlich.</translation>
    </message>
    <message>
        <source>The rotor&apos;s motion needs a positive rate, sample time and tilt of at most 180 degrees.</source>
        <translation>Die Läuferbewegung braucht eine positive Drehrate, eine positive Abtastzeit und eine positive Neigung von höchstens 180 Grad.</translation>
    </message>
    <message>
        <source>The table of poses is empty.</source>
        <translation>Die Posentabelle ist leer.</translation>
    </message>
    <message>
        <source>the spherical motor has no parameter &apos;{}&apos;</source>
        <translation>der Kugelmotor hat keinen Parameter „{}“</translation>
    </message>
    <message>
        <source>A number of the orientation sensing is not finite.</source>
        <translation>Eine Zahl der Orientierungsmessung ist nicht endlich.</translation>
    </message>
    <message>
        <source>The deviation of every field reading must be positive.</source>
        <translation>Die Streuung jedes Feldmesswerts muss positiv sein.</translation>
    </message>
    <message>
        <source>The strength q of the rotor&apos;s field must be positive.</source>
        <translation>Die Stärke q des Läuferfelds muss positiv sein.</translation>
    </message>
    <message>
        <source>A magnet poled the other way is the same one turned by 90 degrees about its shaft.</source>
        <translation>Ein umgekehrt gepolter Magnet ist derselbe, um 90 Grad um seine Welle gedreht.</translation>
    </message>
    <message>
        <source>The reference radius of the rotor&apos;s field must be positive.</source>
        <translation>Der Bezugsradius des Läuferfelds muss positiv sein.</translation>
    </message>
    <message>
        <source>The estimators need harmonics of even degree and even order.</source>
        <translation>Die Schätzer brauchen Kugelflächenfunktionen von geradem Grad und gerader Ordnung.</translation>
    </message>
    <message>
        <source>Others break the symmetry of the four-pole rotor.</source>
        <translation>Andere brechen die Symmetrie des vierpoligen Läufers.</translation>
    </message>
    <message>
        <source>A setting of the particle swarm is not a finite number.</source>
        <translation>Eine Einstellung des Partikelschwarms ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>The box of the particle swarm is empty.</source>
        <translation>Der Suchbereich des Partikelschwarms ist leer.</translation>
    </message>
    <message>
        <source>The particle swarm needs 1 to 128 particles and numbers of steps of at least 0.</source>
        <translation>Der Partikelschwarm braucht 1 bis 128 Partikel und Schrittzahlen von mindestens 0.</translation>
    </message>
    <message>
        <source>Thresholds, pulls and stops of the particle swarm are at least zero, its limits of velocity and step positive.</source>
        <translation>Schwellen, Anziehungen und Abbruchwerte des Partikelschwarms sind mindestens null, seine Grenzen für Geschwindigkeit und Schritt positiv.</translation>
    </message>
    <message>
        <source>gains with set-point weights or filters are applied at once, not in small steps</source>
        <translation>Reglerparameter mit Sollwertgewichten oder Filtern werden auf einmal übernommen, nicht in kleinen Schritten</translation>
    </message>
    <message>
        <source>switch small steps off</source>
        <translation>schalten Sie die kleinen Schritte aus</translation>
    </message>
    <message>
        <source>the law on the device has set-point weights or filters</source>
        <translation>das Regelgesetz im Gerät hat Sollwertgewichte oder Filter</translation>
    </message>
    <message>
        <source>apply the gains at once: that takes them out</source>
        <translation>übernehmen Sie die Reglerparameter auf einmal: das entfernt sie</translation>
    </message>
    <message>
        <source>set-point weight b</source>
        <translation>Sollwertgewicht b</translation>
    </message>
    <message>
        <source>set-point weight c</source>
        <translation>Sollwertgewicht c</translation>
    </message>
    <message>
        <source>filter on the derivative</source>
        <translation>Filter am D-Anteil</translation>
    </message>
    <message>
        <source>filters in series</source>
        <translation>Filter in Reihe</translation>
    </message>
    <message>
        <source>more than {} filters in series</source>
        <translation>mehr als {} Filter in Reihe</translation>
    </message>
    <message>
        <source>the law of this board has no {}</source>
        <translation>das Regelgesetz dieses Steuergeräts bietet nicht: {}</translation>
    </message>
    <message>
        <source>, no </source>
        <translation>, </translation>
    </message>
    <message>
        <source>take it out of the gains, or save the law as C code for another controller</source>
        <translation>nehmen Sie es aus den Reglerparametern heraus, oder speichern Sie das Regelgesetz als C-Code für einen anderen Regler</translation>
    </message>
    <message>
        <source>these gains need a board whose law has their set-point weights and filters</source>
        <translation>diese Reglerparameter brauchen ein Steuergerät, dessen Regelgesetz ihre Sollwertgewichte und Filter hat</translation>
    </message>
    <message>
        <source>tune --gains FILE --apply DEVICE says whether it has; else save the law as C code</source>
        <translation>tune --gains DATEI --apply GERÄT sagt, ob es sie hat; sonst speichern Sie das Regelgesetz als C-Code</translation>
    </message>
    <message>
        <source>The closed form of the additive model needs sensor 1 at (0, 0, 45 degrees).</source>
        <translation>Die geschlossene Form des additiven Modells braucht Sensor 1 bei (0, 0, 45 Grad).</translation>
    </message>
</context>
<context>
    <name>halbench::app::ArmButton</name>
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
</context>
<context>
    <name>halbench::app::ArrangementNotice</name>
    <message>
        <source>The arrangement of the panels in %1 is damaged; the first one is shown.</source>
        <translation>Die Anordnung der Bereiche in %1 ist beschädigt; die erste wird gezeigt.</translation>
    </message>
    <message>
        <source>The arrangement of the panels in %1 is from a newer version; the first one is shown.</source>
        <translation>Die Anordnung der Bereiche in %1 stammt aus einer neueren Version; die erste wird gezeigt.</translation>
    </message>
    <message>
        <source>The arrangement of the panels in %1 is from an older version; the first one is shown.</source>
        <translation>Die Anordnung der Bereiche in %1 stammt aus einer älteren Version; die erste wird gezeigt.</translation>
    </message>
    <message>
        <source>Nothing of it is lost: it stays in the file under the name %1.</source>
        <translation>Nichts davon ist verloren: Sie bleibt in der Datei unter dem Namen %1.</translation>
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
        <source>Ha&amp;ll sensors</source>
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
        <source>Static fr&amp;iction</source>
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
    <message>
        <source>What the Hall sensors read; centre, axes and tilt of the ellipse are measured</source>
        <translation>Was die Hall-Sensoren lesen; gemessen werden Mitte, Achsen und Neigung der Ellipse</translation>
    </message>
    <message>
        <source>It can be applied to the device it was measured on only; calibrate again when the sensors were touched.</source>
        <translation>Sie lässt sich nur auf das Gerät anwenden, an dem sie gemessen wurde; nach Arbeiten an den Sensoren neu kalibrieren.</translation>
    </message>
    <message>
        <source>Hall ellipse</source>
        <translation>Hall-Ellipse</translation>
    </message>
    <message>
        <source>What the Hall sensors read, and the ellipse that was fitted to it</source>
        <translation>Was die Hall-Sensoren messen, und die daran angepasste Ellipse</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>How far the readings lie outside of the ellipse, over the angle</source>
        <translation>Wie weit die Messwerte außerhalb der Ellipse liegen, über dem Winkel</translation>
    </message>
    <message>
        <source>Static friction</source>
        <translation>Haftreibung</translation>
    </message>
    <message>
        <source>Current at the first motion over the angle, both ways</source>
        <translation>Strom bei der ersten Bewegung über dem Winkel, in beiden Richtungen</translation>
    </message>
    <message>
        <source>Pictures of the calibration</source>
        <translation>Bilder der Kalibrierung</translation>
    </message>
    <message>
        <source>The board has these values.</source>
        <translation>Das Steuergerät hat diese Werte.</translation>
    </message>
    <message>
        <source>The board does not have these values yet: Apply writes them. Calibrate again when the sensors were touched.</source>
        <translation>Das Steuergerät hat diese Werte noch nicht: „Übernehmen“ schreibt sie. Kalibrieren Sie neu, wenn die Sensoren berührt wurden.</translation>
    </message>
    <message>
        <source>On the device</source>
        <translation>Auf dem Gerät</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Applied and read back; it stays until the simulated device is disconnected.</source>
        <translation>Übernommen und zurückgelesen; gilt, bis das simulierte Gerät getrennt wird.</translation>
    </message>
    <message>
        <source>The rotor moves (Ctrl+Return); Esc stops it</source>
        <translation>Der Rotor bewegt sich (Strg+Eingabe); Esc stoppt ihn</translation>
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
        <source>device not known</source>
        <translation>Gerät nicht bekannt</translation>
    </message>
    <message>
        <source>From the project: calibrated in virtual time, device %1.</source>
        <translation>Aus dem Projekt: in virtueller Zeit kalibriert, Gerät %1.</translation>
    </message>
    <message>
        <source>From the project: calibrated %1, device %2.</source>
        <translation>Aus dem Projekt: kalibriert %1, Gerät %2.</translation>
    </message>
    <message>
        <source>angle error, cosine part %1</source>
        <translation>Winkelfehler, Kosinusanteil %1</translation>
    </message>
    <message>
        <source>angle error, sine part %1</source>
        <translation>Winkelfehler, Sinusanteil %1</translation>
    </message>
    <message>
        <source>angle error that the map takes away, rms</source>
        <translation>Winkelfehler, den die Korrektur wegnimmt, Effektivwert</translation>
    </message>
    <message>
        <source>breakaway current, from rest</source>
        <translation>Losbrechstrom, aus der Ruhe</translation>
    </message>
    <message>
        <source>Residual angle error: %1 with the values from before, %2 with the proposed ones.</source>
        <translation>Restwinkelfehler: %1 mit den Werten von vorher, %2 mit den vorgeschlagenen.</translation>
    </message>
    <message>
        <source>It is the root mean square (rms) over a turn of the distance between the angle that is read and that of the ellipse, before the map.</source>
        <translation>Er ist der Effektivwert über eine Umdrehung des Abstands zwischen dem gelesenen Winkel und dem der Ellipse, vor der Korrekturtabelle.</translation>
    </message>
    <message>
        <source>The breakaway current is the one that starts the rotor from rest. Identify finds another figure: K_f/φ, the current that friction takes while it moves, usually less.</source>
        <translation>Der Losbrechstrom setzt den Rotor aus der Ruhe in Gang. Das Identifizieren findet eine andere Größe: K_f/φ, den Strom, den die Reibung während der Drehung braucht, meist weniger.</translation>
    </message>
    <message>
        <source>What is the difference?</source>
        <translation>Worin liegt der Unterschied?</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 %2. Nothing is changed until you apply it.</source>
        <translation>Das Steuergerät beendet die Bewegung bei %1 %2. Nichts wird geändert, bis Sie es übernehmen.</translation>
    </message>
    <message>
        <source>Measured before the last connect, device %1.</source>
        <translation>Gemessen vor dem letzten Verbinden, Gerät %1.</translation>
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
    <message>
        <source>fitted ellipse</source>
        <translation>angepasste Ellipse</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>Hall B</translation>
    </message>
    <message>
        <source>Hall readings and their ellipse</source>
        <translation>Hall-Messwerte und ihre Ellipse</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>Hall A</translation>
    </message>
    <message>
        <source>reading minus ellipse</source>
        <translation>Messwert minus Ellipse</translation>
    </message>
    <message>
        <source>What the ellipse leaves over</source>
        <translation>Was die Ellipse übrig lässt</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConfigurationPanel</name>
    <message>
        <source>Save settings …</source>
        <translation>Einstellungen speichern …</translation>
    </message>
    <message>
        <source>Writes all settings of the device into a file</source>
        <translation>Schreibt alle Einstellungen des Geräts in eine Datei</translation>
    </message>
    <message>
        <source>Compare with …</source>
        <translation>Vergleichen mit …</translation>
    </message>
    <message>
        <source>Shows a file beside the device; nothing is written yet</source>
        <translation>Zeigt eine Datei neben dem Gerät; noch wird nichts geschrieben</translation>
    </message>
    <message>
        <source>No configuration file is open</source>
        <translation>Keine Konfigurationsdatei ist offen</translation>
    </message>
    <message>
        <source>A file shows row by row what differs from the device, to restore what you tick. Before that, what the device has is kept.</source>
        <translation>Eine Datei zeigt Zeile für Zeile, was vom Gerät abweicht; wiederhergestellt wird, was Sie ankreuzen. Vorher wird aufbewahrt, was das Gerät hat.</translation>
    </message>
    <message>
        <source>Compare with a file …</source>
        <translation>Mit einer Datei vergleichen …</translation>
    </message>
    <message>
        <source>Only what &amp;differs</source>
        <translation>Nur A&amp;bweichendes</translation>
    </message>
    <message>
        <source>Hides rows that are the same or not in the file</source>
        <translation>Verbirgt Zeilen, die gleich oder nicht in der Datei sind</translation>
    </message>
    <message>
        <source>With &amp;calibration</source>
        <translation>Mit &amp;Kalibrierung</translation>
    </message>
    <message>
        <source>Ticks what was measured on one device; measured on another device, it is wrong on this one</source>
        <translation>Kreuzt an, was an einem Gerät gemessen wurde; an einem anderen gemessen, ist es an diesem falsch</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Writes the ticked rows in one step and reads them back; they last until power-down unless they are saved in the device</source>
        <translation>Schreibt die angekreuzten Zeilen in einem Schritt und liest sie zurück; sie gelten bis zum Ausschalten, wenn sie nicht im Gerät gespeichert werden</translation>
    </message>
    <message numerus="yes">
        <source>Restore %n row(s)</source>
        <translation>
            <numerusform>%n Zeile wiederherstellen</numerusform>
            <numerusform>%n Zeilen wiederherstellen</numerusform>
        </translation>
    </message>
    <message>
        <source>Save settings</source>
        <translation>Einstellungen speichern</translation>
    </message>
    <message>
        <source>Configuration (*.toml)</source>
        <translation>Konfiguration (*.toml)</translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) saved.</source>
        <translation>
            <numerusform>%n Einstellung gespeichert.</numerusform>
            <numerusform>%n Einstellungen gespeichert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>%1: device %2, firmware %3, written %4</source>
        <translation>%1: Gerät %2, Firmware %3, geschrieben %4</translation>
    </message>
    <message>
        <source>What the device had before is kept in %1.</source>
        <translation>Was das Gerät vorher hatte, liegt in %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) not restored; the rows say why.</source>
        <translation>
            <numerusform>%n Zeile nicht wiederhergestellt; die Zeilen sagen, warum.</numerusform>
            <numerusform>%n Zeilen nicht wiederhergestellt; die Zeilen sagen, warum.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) restored and read back.</source>
        <translation>
            <numerusform>%n Zeile wiederhergestellt und zurückgelesen.</numerusform>
            <numerusform>%n Zeilen wiederhergestellt und zurückgelesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>They last until power-down; Save in the device, in Parameters, keeps them.</source>
        <translation>Sie gelten bis zum Ausschalten; „Im Gerät speichern“ unter Parameter behält sie.</translation>
    </message>
    <message>
        <source>configuration</source>
        <translation>Konfiguration</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConfigurationTable</name>
    <message>
        <source>Rows of the configuration</source>
        <translation>Zeilen der Konfiguration</translation>
    </message>
    <message>
        <source>Ticked rows are restored (Space ticks); numbers are in SI units, as in the file</source>
        <translation>Angekreuzte Zeilen werden wiederhergestellt (Leertaste kreuzt an); Zahlen in SI-Einheiten wie in der Datei</translation>
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
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>restored</source>
        <translation>wiederhergestellt</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>not in the file</source>
        <translation>nicht in der Datei</translation>
    </message>
    <message>
        <source>not restored</source>
        <translation>nicht wiederhergestellt</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>differs, and was measured on one device: wrong on another</source>
        <translation>verschieden, und an einem Gerät gemessen: an einem anderen falsch</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConnectButton</name>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Connect the device of the Devices panel; the menu lists what is there (Ctrl+Shift+C, Alt+Down)</source>
        <translation>Das Gerät des Bereichs Geräte verbinden; das Menü nennt, was da ist (Strg+Umschalt+C, Alt+Ab)</translation>
    </message>
    <message>
        <source>End what runs, disarm and disconnect (Ctrl+Shift+C)</source>
        <translation>Beenden, was läuft, sperren und trennen (Strg+Umschalt+C)</translation>
    </message>
    <message>
        <source>End the search for the device (Ctrl+Shift+C)</source>
        <translation>Die Suche nach dem Gerät beenden (Strg+Umschalt+C)</translation>
    </message>
</context>
<context>
    <name>halbench::app::DepartureWords</name>
    <message>
        <source>It ended because the connection to the device was lost: %1.</source>
        <translation>Beendet, weil die Verbindung zum Gerät abriss: %1.</translation>
    </message>
    <message>
        <source>The board&apos;s watchdog disarms it by itself. Begin anew when it is connected again.</source>
        <translation>Der Watchdog des Steuergeräts sperrt es von selbst. Beginnen Sie neu, wenn es wieder verbunden ist.</translation>
    </message>
    <message>
        <source>It ended because the device was disconnected.</source>
        <translation>Beendet, weil das Gerät getrennt wurde.</translation>
    </message>
    <message>
        <source>The board was disarmed first, and everything on it is as it was before. Begin anew when it is connected again.</source>
        <translation>Das Steuergerät wurde zuerst gesperrt, und alles darauf ist, wie es war. Beginnen Sie neu, wenn es wieder verbunden ist.</translation>
    </message>
</context>
<context>
    <name>halbench::app::DerivedPanel</name>
    <message>
        <source>What is wrong with the expression</source>
        <translation>Was am Ausdruck falsch ist</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>Ausdruck</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Derived signals</source>
        <translation>Abgeleitete Signale</translation>
    </message>
    <message>
        <source>Enter takes a row into the fields above, Delete removes it</source>
        <translation>Eingabe übernimmt eine Zeile in die Felder oben, Entf entfernt sie</translation>
    </message>
    <message>
        <source>As it shall stand in the tree: letters, digits, dots, underscores</source>
        <translation>Wie es im Baum stehen soll: Buchstaben, Ziffern, Punkte, Unterstriche</translation>
    </message>
    <message>
        <source>Of names of signals in SI units, e.g. current.a^2 + current.b^2; + - * / ^, sin, cos, atan2, sqrt, abs, exp, ln, min, max, pi. Enter keeps it</source>
        <translation>Aus Namen von Signalen in SI-Einheiten, z. B. current.a^2 + current.b^2; + - * / ^, sin, cos, atan2, sqrt, abs, exp, ln, min, max, pi. Eingabe behält es</translation>
    </message>
    <message>
        <source>Of the value; empty: as it follows from the expression. A symbol such as rad, rad/s, T, A, degC is shown in the preferred unit</source>
        <translation>Des Wertes; leer: wie sie aus dem Ausdruck folgt. Ein Zeichen wie rad, rad/s, T, A, degC wird in der bevorzugten Einheit gezeigt</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Computes the signal from now on (Enter)</source>
        <translation>Berechnet das Signal ab jetzt (Eingabe)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the signal that is chosen below (Delete)</source>
        <translation>Entfernt das unten gewählte Signal (Entf)</translation>
    </message>
    <message>
        <source>waits for a device</source>
        <translation>wartet auf ein Gerät</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>wird berechnet</translation>
    </message>
</context>
<context>
    <name>halbench::app::DesignNames</name>
    <message>
        <source>recommended</source>
        <translation>empfohlen</translation>
    </message>
    <message>
        <source>pole placement</source>
        <translation>Polvorgabe</translation>
    </message>
    <message>
        <source>bandwidth</source>
        <translation>Bandbreite</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>SIMC</source>
        <translation>SIMC</translation>
    </message>
    <message>
        <source>lambda</source>
        <translation>Lambda</translation>
    </message>
    <message>
        <source>Ziegler-Nichols PID</source>
        <translation>Ziegler-Nichols PID</translation>
    </message>
    <message>
        <source>Ziegler-Nichols PI</source>
        <translation>Ziegler-Nichols PI</translation>
    </message>
    <message>
        <source>Ziegler-Nichols P</source>
        <translation>Ziegler-Nichols P</translation>
    </message>
    <message>
        <source>LQR</source>
        <translation>LQR</translation>
    </message>
    <message>
        <source>least IAE</source>
        <translation>kleinstes IAE</translation>
    </message>
    <message>
        <source>least ITAE</source>
        <translation>kleinstes ITAE</translation>
    </message>
    <message>
        <source>lead</source>
        <translation>Lead (PD)</translation>
    </message>
    <message>
        <source>lag</source>
        <translation>Lag (PI)</translation>
    </message>
    <message>
        <source>published</source>
        <translation>veröffentlicht</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>ausgelegt</translation>
    </message>
    <message>
        <source>micro-step</source>
        <translation>Mikroschritt</translation>
    </message>
    <message>
        <source>published, in degrees</source>
        <translation>veröffentlicht, in Grad</translation>
    </message>
    <message>
        <source>from the device</source>
        <translation>vom Gerät</translation>
    </message>
    <message>
        <source>edited by hand</source>
        <translation>von Hand bearbeitet</translation>
    </message>
</context>
<context>
    <name>halbench::app::DesignTable</name>
    <message>
        <source>stable</source>
        <translation>stabil</translation>
    </message>
    <message>
        <source>UNSTABLE</source>
        <translation>INSTABIL</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Vorgeschlagen</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Amplituden­reserve</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Phasen­reserve</translation>
    </message>
    <message>
        <source>Delay margin</source>
        <translation>Totzeitreserve</translation>
    </message>
    <message>
        <source>Bandwidth</source>
        <translation>Bandbreite</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Designs compared</source>
        <translation>Entwürfe im Vergleich</translation>
    </message>
    <message>
        <source>A tick draws the design in the pictures (Space), F2 renames it, Del removes it</source>
        <translation>Ein Häkchen zeichnet den Entwurf in die Bilder (Leertaste), F2 benennt ihn um, Entf entfernt ihn</translation>
    </message>
    <message>
        <source>Keep this design</source>
        <translation>Entwurf behalten</translation>
    </message>
    <message>
        <source>The proposed gains stay in the project, under a name of their own</source>
        <translation>Die vorgeschlagenen Verstärkungen bleiben unter eigenem Namen im Projekt</translation>
    </message>
    <message>
        <source>Take up</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>The gains of the chosen design become the proposed ones</source>
        <translation>Die Verstärkungen des gewählten Entwurfs werden die vorgeschlagenen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>The chosen design leaves the project</source>
        <translation>Der gewählte Entwurf wird aus dem Projekt entfernt</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>What was last done to the list of designs is taken back (Ctrl+Z)</source>
        <translation>Was zuletzt an der Liste der Entwürfe geschah, wird zurückgenommen (Strg+Z)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>What was taken back is done again (Ctrl+Shift+Z)</source>
        <translation>Was zurückgenommen wurde, geschieht wieder (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>%1, with filters</source>
        <translation>%1, mit Filtern</translation>
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
    <message>
        <source>Ending what runs and disarming …</source>
        <translation>Laufendes wird beendet und der Aktor gesperrt …</translation>
    </message>
    <message>
        <source>%1, last used</source>
        <translation>%1, zuletzt verwendet</translation>
    </message>
    <message>
        <source>End the search for the device (Alt+C)</source>
        <translation>Die Suche nach dem Gerät beenden (Alt+C)</translation>
    </message>
    <message>
        <source>Connection lost. Looking for %1 …</source>
        <translation>Verbindung verloren. %1 wird gesucht …</translation>
    </message>
    <message>
        <source>Description of the board</source>
        <translation>Beschreibung des Steuergeräts</translation>
    </message>
    <message>
        <source>Description (*.a2l)</source>
        <translation>Beschreibung (*.a2l)</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>nicht genannt</translation>
    </message>
    <message>
        <source>Description file…</source>
        <translation>Beschreibungsdatei …</translation>
    </message>
    <message>
        <source>Description file of a board that does not describe itself: the A2L file that its maker gives with it</source>
        <translation>Beschreibungsdatei eines Steuergeräts, das sich nicht selbst beschreibt: die A2L-Datei, die sein Hersteller mitgibt</translation>
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
    <message>
        <source>%1 more lines came too fast to be shown</source>
        <translation>%1 weitere Zeilen kamen zu schnell, um gezeigt zu werden</translation>
    </message>
    <message>
        <source>%1 is back after %2 s, disarmed</source>
        <translation>%1 ist nach %2 s wieder da, gesperrt</translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) came faster than the window could show them and are not drawn</source>
        <translation>
            <numerusform>%Ln Zeile kam schneller, als das Fenster sie zeigen konnte, und ist nicht gezeichnet</numerusform>
            <numerusform>%Ln Zeilen kamen schneller, als das Fenster sie zeigen konnte, und sind nicht gezeichnet</numerusform>
        </translation>
    </message>
    <message>
        <source>armed: it is disarmed before it is left</source>
        <translation>freigegeben: es wird gesperrt, bevor die Verbindung getrennt wird</translation>
    </message>
</context>
<context>
    <name>halbench::app::DisplayQuantity</name>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
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
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>rev</source>
        <translation>U</translation>
    </message>
    <message>
        <source>rev/s</source>
        <translation>U/s</translation>
    </message>
</context>
<context>
    <name>halbench::app::DockMenu</name>
    <message>
        <source>Puts the panel into a window of its own, with a STOP of its own, or back where it was</source>
        <translation>Löst den Bereich in ein eigenes Fenster mit eigenem STOPP oder dockt ihn wieder an, wo er war</translation>
    </message>
    <message>
        <source>Moves the panel behind the next one on that side, or along that edge of the window</source>
        <translation>Verschiebt den Bereich zum nächsten auf dieser Seite oder an diesen Rand des Fensters</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>Nach &amp;links</translation>
    </message>
    <message>
        <source>Move &amp;right</source>
        <translation>Nach &amp;rechts</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>Changes the size of the panel, at the expense of what is beside it</source>
        <translation>Ändert die Größe des Bereichs auf Kosten dessen, was daneben liegt</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>&amp;Breiter</translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation>&amp;Schmaler</translation>
    </message>
    <message>
        <source>&amp;Taller</source>
        <translation>&amp;Höher</translation>
    </message>
    <message>
        <source>&amp;Arrange the panel</source>
        <translation>Den Bereich &amp;anordnen</translation>
    </message>
    <message>
        <source>&amp;Arrange the panel “%1”</source>
        <translation>Den Bereich „%1“ &amp;anordnen</translation>
    </message>
    <message>
        <source>Dock it &amp;back</source>
        <translation>Wieder &amp;andocken</translation>
    </message>
    <message>
        <source>&amp;Float in its own window</source>
        <translation>In ein eigenes &amp;Fenster lösen</translation>
    </message>
    <message>
        <source>&amp;Shorter</source>
        <translation>&amp;Niedriger</translation>
    </message>
</context>
<context>
    <name>halbench::app::DocumentFiles</name>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Picture (*.svg *.pdf *.png)</source>
        <translation>Bild (*.svg *.pdf *.png)</translation>
    </message>
    <message>
        <source>Its numbers (*.csv)</source>
        <translation>Seine Zahlen (*.csv)</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveControl</name>
    <message>
        <source>Not started: this firmware (%1) begins where it was armed, so the rotor would leap.</source>
        <translation>Nicht gestartet: Diese Firmware (%1) beginnt, wo freigegeben wurde; der Rotor würde springen.</translation>
    </message>
    <message>
        <source>Disarm and arm, then start. Firmware from 0.2.0 on goes on from where it holds.</source>
        <translation>Sperren und freigeben, dann starten. Firmware ab 0.2.0 geht von dort weiter, wo sie hält.</translation>
    </message>
    <message>
        <source>Not sent: a reference runs, and more than %1° at once is a leap.</source>
        <translation>Nicht gesendet: Ein Sollwertverlauf läuft, und mehr als %1° auf einmal sind ein Sprung.</translation>
    </message>
    <message>
        <source>Not sent: more than %1° at once is a leap, and the firmware of this board makes no ramp of it.</source>
        <translation>Nicht gesendet: Mehr als %1° auf einmal sind ein Sprung, und die Firmware dieses Steuergeräts macht keine Rampe daraus.</translation>
    </message>
    <message>
        <source>End the reference first; then the board goes there as an even ramp.</source>
        <translation>Beenden Sie erst den Sollwertverlauf; dann fährt das Steuergerät in gleichmäßiger Rampe dorthin.</translation>
    </message>
    <message>
        <source>Go there in smaller steps, or jog. Firmware from 0.2.0 on makes a ramp.</source>
        <translation>Gehen Sie in kleineren Schritten oder im Tippbetrieb dorthin. Firmware ab 0.2.0 macht eine Rampe.</translation>
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
        <source>&apos;%1&apos; is not a limit, nothing was written.</source>
        <translation>„%1“ ist keine Grenze; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Enter writes it; until power-down, unless it is saved in the device</source>
        <translation>Enter schreibt ihn; bis zum Ausschalten, wenn er nicht im Gerät gespeichert wird</translation>
    </message>
</context>
<context>
    <name>halbench::app::DrivePanel</name>
    <message>
        <source>Drive it from the command line. STOP, Signals, Parameters and Record work here.</source>
        <translation>Auf der Kommandozeile bewegen. STOPP, Signale, Parameter und Aufzeichnen gehen hier.</translation>
    </message>
    <message>
        <source>This device has several axes: it is not armed or driven from here.</source>
        <translation>Dieses Gerät hat mehrere Achsen: Von hier aus wird es nicht freigegeben und nicht bewegt.</translation>
    </message>
    <message>
        <source>What the board says of itself</source>
        <translation>Was das Steuergerät über sich sagt</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>&amp;Modus</translation>
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
        <source>Set-point</source>
        <translation>Sollwert</translation>
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
        <source>A stop came while nothing was armed</source>
        <translation>Es kam ein Stopp, während nichts freigegeben war</translation>
    </message>
    <message>
        <source>%1 is beyond the excursion window, nothing was sent.</source>
        <translation>%1 liegt außerhalb der zulässigen Auslenkung, nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>From %1 to %2 now. Widen the window on purpose, or disarm and arm to count anew.</source>
        <translation>Jetzt von %1 bis %2. Das Fenster mit Absicht erweitern, oder sperren und freigeben, um neu zu zählen.</translation>
    </message>
    <message>
        <source>Armed, %1</source>
        <translation>Freigegeben, %1</translation>
    </message>
    <message>
        <source>They last until power-down; Save in the device, in Parameters, keeps them.</source>
        <translation>Sie gelten bis zum Ausschalten; „Im Gerät speichern“ unter Parameter behält sie.</translation>
    </message>
    <message>
        <source>This device cannot be armed, driven or stopped from here: it has no parameter hb.arm.</source>
        <translation>Dieses Gerät lässt sich von hier weder freigeben noch bewegen noch anhalten: Es hat keinen Parameter hb.arm.</translation>
    </message>
    <message>
        <source>Use its maker&apos;s program and the switch at the actuator. Signals, Parameters and Record work with it by name.</source>
        <translation>Das Programm des Herstellers und den Schalter am Aktor verwenden. Signale, Parameter und Aufnahme arbeiten mit seinen Namen.</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>Nicht bekannt</translation>
    </message>
    <message>
        <source>Now %1, beside %2 by jog or reference</source>
        <translation>Jetzt %1, dazu %2 durch Tippen oder Führungsgröße</translation>
    </message>
    <message>
        <source>Sends the set-point zero: steps back %1</source>
        <translation>Sendet den Sollwert null: springt um %1 zurück</translation>
    </message>
    <message>
        <source>Sends the set-point zero: moves back %1 at the jog speed</source>
        <translation>Sendet den Sollwert null: fährt um %1 mit der Tippdrehzahl zurück</translation>
    </message>
    <message>
        <source>Sends the set-point (Enter in the field); more than 30° away it
is approached as an even ramp at the jog speed</source>
        <translation>Sendet den Sollwert (Eingabetaste im Feld); mehr als 30° entfernt
wird er in gleichmäßiger Rampe mit Tippdrehzahl angefahren</translation>
    </message>
    <message>
        <source>Waits for a sample of the angle.</source>
        <translation>Wartet auf einen Messwert des Winkels.</translation>
    </message>
    <message>
        <source>Beside what a reference has moved it (Enter sends it)</source>
        <translation>Neben dem, was eine Führungsgröße bewegt hat (Enter sendet ihn)</translation>
    </message>
    <message>
        <source>Starts the reference from where the rotor is held: each start adds
its way to the one before (Ctrl+Shift+R)</source>
        <translation>Startet den Verlauf dort, wo der Rotor gehalten wird: Jeder Start legt
seinen Weg zum vorigen dazu (Strg+Umschalt+R)</translation>
    </message>
    <message>
        <source> (at %1)</source>
        <translation> (bei %1)</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Angle from where it will be armed</source>
        <translation>Winkel ab der Stelle beim Freigeben</translation>
    </message>
    <message>
        <source>Angle from where the mode was chosen</source>
        <translation>Winkel ab der Stelle bei der Wahl der Betriebsart</translation>
    </message>
    <message>
        <source>Angle from where it was armed</source>
        <translation>Winkel ab der Stelle beim Freigeben</translation>
    </message>
    <message>
        <source>Moves up to %1 from where it is, then up to %2 from where it was armed.</source>
        <translation>Bewegt sich bis zu %1 von der jetzigen Stelle, dann bis zu %2 von der beim Freigeben.</translation>
    </message>
    <message>
        <source>Start waits until this motion has ended, or End ends it.</source>
        <translation>Start wartet, bis diese Bewegung vorbei ist oder „Ende“ sie beendet.</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveWords</name>
    <message>
        <source>reference</source>
        <translation>Führungsgröße</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>staircase</source>
        <translation>Treppe</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>Chirp</translation>
    </message>
    <message>
        <source>multisine</source>
        <translation>Multisinus</translation>
    </message>
    <message>
        <source>plateaus</source>
        <translation>Plateaus</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>Leerlauf</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>d-axis</source>
        <translation>D-Achse</translation>
    </message>
    <message>
        <source>jogging</source>
        <translation>Tippbetrieb</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 auf %2</translation>
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
    <message>
        <source>A converter that drives a coil does not answer</source>
        <translation>Ein Wandler, der eine Spule ansteuert, antwortet nicht</translation>
    </message>
    <message>
        <source>Look at the board&apos;s cables and supply, then release the stop.</source>
        <translation>Prüfen Sie Kabel und Versorgung der Steuerung und heben Sie dann den Stopp auf.</translation>
    </message>
    <message>
        <source>by command</source>
        <translation>durch Befehl</translation>
    </message>
    <message>
        <source>by the watchdog</source>
        <translation>durch Überwachungszeit</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Gestoppt: %1</translation>
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
    <name>halbench::app::FilterEditor</name>
    <message>
        <source>Edit %1</source>
        <translation>%1 bearbeiten</translation>
    </message>
    <message>
        <source>Add a filter</source>
        <translation>Filter hinzufügen</translation>
    </message>
    <message>
        <source>Choose the kind of filter %1</source>
        <translation>Art von Filter %1 wählen</translation>
    </message>
    <message>
        <source>Remove a filter</source>
        <translation>Filter entfernen</translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>eine Zahl fehlt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Write a number within its range</source>
        <translation>Schreiben Sie eine Zahl in ihrem Bereich</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Lead</translation>
    </message>
    <message>
        <source>Lag</source>
        <translation>Lag</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>Notch</translation>
    </message>
    <message>
        <source>Low-pass</source>
        <translation>Tiefpass</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Gain at rest</source>
        <translation>Verstärkung in Ruhe</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Eckfrequenz</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Filter %1</source>
        <translation>Filter %1</translation>
    </message>
    <message>
        <source>%1: kind</source>
        <translation>%1: Art</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Weights and filters</source>
        <translation>Gewichte und Filter</translation>
    </message>
    <message>
        <source>In series with the others, four at most; a low-pass at first</source>
        <translation>In Reihe mit den anderen, höchstens vier; zuerst ein Tiefpass</translation>
    </message>
    <message>
        <source>Weight b of the set-point</source>
        <translation>Gewicht b des Sollwerts</translation>
    </message>
    <message>
        <source>Of K_P: below 1 a step is answered more gently</source>
        <translation>Von K_P: unter 1 wird ein Sprung sanfter beantwortet</translation>
    </message>
    <message>
        <source>Weight c of the set-point</source>
        <translation>Gewicht c des Sollwerts</translation>
    </message>
    <message>
        <source>Filter on the derivative</source>
        <translation>Filter am D-Anteil</translation>
    </message>
    <message>
        <source>Where the phase is added; the gain there stays</source>
        <translation>Wo die Phase dazukommt; die Verstärkung bleibt dort</translation>
    </message>
    <message>
        <source>Added at that frequency</source>
        <translation>Kommt bei dieser Frequenz dazu</translation>
    </message>
    <message>
        <source>Far above it the gain stays</source>
        <translation>Weit darüber bleibt die Verstärkung</translation>
    </message>
    <message>
        <source>Factor on the gain at rest, above 1</source>
        <translation>Faktor auf die Verstärkung in Ruhe, über 1</translation>
    </message>
    <message>
        <source>Where the gain is least</source>
        <translation>Wo die Verstärkung am kleinsten ist</translation>
    </message>
    <message>
        <source>Factor on the gain at that frequency, 0 to 1</source>
        <translation>Faktor auf die Verstärkung bei dieser Frequenz, 0 bis 1</translation>
    </message>
    <message>
        <source>Of its poles: the more, the wider it is</source>
        <translation>Seiner Pole: je mehr, desto breiter</translation>
    </message>
    <message>
        <source>There the gain has fallen by 3 dB</source>
        <translation>Dort ist die Verstärkung um 3 dB gefallen</translation>
    </message>
    <message>
        <source>1 or 2</source>
        <translation>1 oder 2</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Glied 2. Ordnung</translation>
    </message>
    <message>
        <source>Coefficient of (b0 d² + b1 d + b2)/(d² + a1 d + a2), d = z − 1</source>
        <translation>Koeffizient von (b0 d² + b1 d + b2)/(d² + a1 d + a2), d = z − 1</translation>
    </message>
    <message>
        <source>Coefficient of d in the numerator</source>
        <translation>Koeffizient von d im Zähler</translation>
    </message>
    <message>
        <source>Coefficient of 1 in the numerator</source>
        <translation>Koeffizient von 1 im Zähler</translation>
    </message>
    <message>
        <source>Coefficient of d in the denominator; 0: no memory</source>
        <translation>Koeffizient von d im Nenner; 0: kein Gedächtnis</translation>
    </message>
    <message>
        <source>Coefficient of 1 in the denominator</source>
        <translation>Koeffizient von 1 im Nenner</translation>
    </message>
    <message>
        <source>Lead: phase at a frequency. Lag: more gain at rest. Notch: little gain at a frequency. Low-pass: little gain above a frequency. Section: by coefficients</source>
        <translation>Lead: Phase bei einer Frequenz. Lag: mehr Verstärkung in Ruhe. Notch: wenig Verstärkung bei einer Frequenz. Tiefpass: wenig Verstärkung über einer Frequenz. Glied 2. Ordnung: durch Koeffizienten</translation>
    </message>
    <message>
        <source>Set-point weights, derivative filter and filters in series</source>
        <translation>Sollwertgewichte, Filter am D-Anteil und Filter in Reihe</translation>
    </message>
    <message>
        <source>Applied to boards whose law offers them; else judged, compared and saved.</source>
        <translation>Werden auf Steuergeräte übernommen, deren Regelgesetz sie bietet; sonst beurteilt, verglichen und gespeichert.</translation>
    </message>
    <message>
        <source>Of K_D: 0 ignores a step of the set-point, 1 sees all of it</source>
        <translation>Von K_D: 0 übergeht einen Sprung des Sollwerts, 1 berücksichtigt ihn ganz</translation>
    </message>
    <message>
        <source>Time constant; 0: the difference of two samples</source>
        <translation>Zeitkonstante; 0: die Differenz zweier Abtastwerte</translation>
    </message>
</context>
<context>
    <name>halbench::app::ForeignMotorNotice</name>
    <message>
        <source>Apply gains of another motor here</source>
        <translation>Reglerparameter eines anderen Motors hier übernehmen</translation>
    </message>
    <message>
        <source>They were designed for a motor that this device may not be</source>
        <translation>Sie wurden für einen Motor entworfen, der dieses Gerät womöglich nicht ist</translation>
    </message>
    <message>
        <source>Whose motor is tuned</source>
        <translation>Wessen Motor eingestellt wird</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyFigures</name>
    <message>
        <source>phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>Amplitudenreserve</translation>
    </message>
    <message>
        <source>Measured open loop</source>
        <translation>Gemessener offener Kreis</translation>
    </message>
    <message>
        <source>Measured plant: angle over current, rad/A</source>
        <translation>Gemessene Strecke: Winkel über Strom, rad/A</translation>
    </message>
    <message>
        <source>Measured closed loop</source>
        <translation>Gemessener geschlossener Kreis</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>measured, not coherent</source>
        <translation>gemessen, nicht kohärent</translation>
    </message>
    <message>
        <source>95 % of it</source>
        <translation>95 % davon</translation>
    </message>
    <message>
        <source>rotor that fits</source>
        <translation>angepasster Rotor</translation>
    </message>
    <message>
        <source>The excitation as recorded</source>
        <translation>Die Anregung, wie aufgezeichnet</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>reference speed</source>
        <translation>Drehzahl der Führungsgröße</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>current amplitude</source>
        <translation>Stromamplitude</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyForm</name>
    <message>
        <source>multisine: many frequencies at once</source>
        <translation>Multisinus: viele Frequenzen zugleich</translation>
    </message>
    <message>
        <source>stepped sine: one after the other</source>
        <translation>Stufensinus: eine nach der anderen</translation>
    </message>
    <message>
        <source>chirp: swept again and again</source>
        <translation>Chirp: immer wieder durchlaufend</translation>
    </message>
    <message>
        <source>E&amp;xcitation</source>
        <translation>An&amp;regung</translation>
    </message>
    <message>
        <source>&amp;Base speed</source>
        <translation>&amp;Grunddrehzahl</translation>
    </message>
    <message>
        <source>&amp;Periods</source>
        <translation>&amp;Perioden</translation>
    </message>
    <message>
        <source>What is added to the steady motion</source>
        <translation>Was zur stetigen Bewegung hinzukommt</translation>
    </message>
    <message>
        <source>A period of the excitation lasts as long as four of it</source>
        <translation>Eine Periode der Anregung dauert so lange wie vier von ihr</translation>
    </message>
    <message>
        <source>At most 45 % of the rate of the position loop</source>
        <translation>Höchstens 45 % der Abtastrate des Lagekreises</translation>
    </message>
    <message>
        <source>Steady speed below the excitation, at least 3 rad/s in either direction: friction is then a plain offset</source>
        <translation>Stetige Drehzahl unter der Anregung, mindestens 3 rad/s in einer der Richtungen: Reibung ist dann ein bloßer Versatz</translation>
    </message>
    <message>
        <source>That are averaged, of a chirp sweeps; the circles of confidence shrink with their root</source>
        <translation>Die gemittelt werden, beim Chirp Durchläufe; die Vertrauenskreise schrumpfen mit der Wurzel ihrer Zahl</translation>
    </message>
    <message>
        <source>Points below it are shown faint and are part of no margin and no fit</source>
        <translation>Punkte darunter werden blass gezeigt und gehören zu keiner Reserve und keiner Anpassung</translation>
    </message>
    <message>
        <source>Of a sine of the same rms, in every band. Empty: as large as is safe</source>
        <translation>Eines Sinus mit gleichem Effektivwert, in jedem Band. Leer: so groß, wie es sicher ist</translation>
    </message>
    <message>
        <source>as large as is safe</source>
        <translation>so groß, wie es sicher ist</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Write the number anew</source>
        <translation>Schreiben Sie die Zahl neu</translation>
    </message>
    <message>
        <source>Lowest frequency</source>
        <translation>Niedrigste Frequenz</translation>
    </message>
    <message>
        <source>Highest frequency</source>
        <translation>Höchste Frequenz</translation>
    </message>
    <message>
        <source>Least coherence</source>
        <translation>Kleinste Kohärenz</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyPanel</name>
    <message>
        <source>Save response</source>
        <translation>Frequenzgang speichern</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>Frequenzgang (*.json)</translation>
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
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Measures the loop with the gains on the board, frequency by frequency: open loop, plant and margins with their 95 % intervals, on top of a steady motion that never turns back.</source>
        <translation>Misst den Kreis mit den Reglerparametern des Steuergeräts, Frequenz für Frequenz: offener Kreis, Strecke und Reserven mit ihren 95-%-Intervallen, auf einer stetigen Bewegung, die nie umkehrt.</translation>
    </message>
    <message>
        <source>The rotor turns steadily and is excited. STOP (Esc) and Cancel end it; mode, windows and generator are restored, the gains stay as they are.</source>
        <translation>Der Rotor dreht sich stetig und wird angeregt. STOPP (Esc) und Abbrechen beenden es; Betriebsart, Fenster und Generator werden wiederhergestellt, die Reglerparameter bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Start measurement</source>
        <translation>Messung starten</translation>
    </message>
    <message>
        <source>The rotor turns (Ctrl+Return); Esc stops it</source>
        <translation>Der Rotor dreht sich (Strg+Eingabe); Esc stoppt ihn</translation>
    </message>
    <message>
        <source>Use in Tune</source>
        <translation>In Auslegung verwenden</translation>
    </message>
    <message>
        <source>Draw the measured points into the open loop of Tune, with the gains proposed there</source>
        <translation>Die gemessenen Punkte in den offenen Kreis der Auslegung zeichnen, mit den dort vorgeschlagenen Reglerparametern</translation>
    </message>
    <message>
        <source>Save response…</source>
        <translation>Frequenzgang speichern …</translation>
    </message>
    <message>
        <source>Write the file that Tune and the program read</source>
        <translation>Die Datei schreiben, die Auslegung und Programm lesen</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>Tabelle speichern …</translation>
    </message>
    <message>
        <source>Write the points with error and coherence as CSV</source>
        <translation>Die Punkte mit Fehler und Kohärenz als CSV schreiben</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next one</source>
        <translation>Zurück zu den Einstellungen; dieses Ergebnis bleibt bis zum nächsten</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Misst</translation>
    </message>
    <message>
        <source>Computing the response</source>
        <translation>Berechnet den Frequenzgang</translation>
    </message>
    <message>
        <source>The measurement was cancelled; everything is as it was before.</source>
        <translation>Die Messung wurde abgebrochen; alles ist wie zuvor.</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyResultView</name>
    <message>
        <source>Margins and fitted rotor</source>
        <translation>Reserven und angepasster Rotor</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>Offener Kreis</translation>
    </message>
    <message>
        <source>With the gains on the board: magnitude, phase and coherence over one frequency</source>
        <translation>Mit den Reglerparametern des Steuergeräts: Betrag, Phase und Kohärenz über einer Frequenzachse</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>From the current to the measured angle, with the rotor that fits</source>
        <translation>Vom Strom zum gemessenen Winkel, mit dem angepassten Rotor</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>Geschlossener Kreis</translation>
    </message>
    <message>
        <source>From the reference to the measured angle</source>
        <translation>Von der Führungsgröße zum gemessenen Winkel</translation>
    </message>
    <message>
        <source>Raw record</source>
        <translation>Rohaufzeichnung</translation>
    </message>
    <message>
        <source>Speed and current over time, as recorded</source>
        <translation>Drehzahl und Strom über der Zeit, wie aufgezeichnet</translation>
    </message>
    <message>
        <source>Pictures of the frequency response</source>
        <translation>Bilder des Frequenzgangs</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyWords</name>
    <message>
        <source>withheld: crosses nowhere</source>
        <translation>zurückgehalten: schneidet nirgends</translation>
    </message>
    <message>
        <source>withheld: crosses in a gap</source>
        <translation>zurückgehalten: schneidet in einer Lücke</translation>
    </message>
    <message>
        <source>withheld: too uncertain</source>
        <translation>zurückgehalten: zu unsicher</translation>
    </message>
    <message>
        <source>The findings above say why, and what helps</source>
        <translation>Die Befunde oben sagen, warum, und was hilft</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>where the loop crosses, at %1 Hz</source>
        <translation>wo der Kreis schneidet, bei %1 Hz</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>angepasst</translation>
    </message>
    <message>
        <source>The rotor will turn in reverse at %1 rad/s (%2 r/min), about %3 turns, for %4 minutes of device time.</source>
        <translation>Der Rotor wird sich rückwärts mit %1 rad/s (%2 1/min) drehen, etwa %3 Umdrehungen, %4 Minuten Gerätezeit lang.</translation>
    </message>
    <message>
        <source>The rotor will turn forward at %1 rad/s (%2 r/min), about %3 turns, for %4 minutes of device time.</source>
        <translation>Der Rotor wird sich vorwärts mit %1 rad/s (%2 1/min) drehen, etwa %3 Umdrehungen, %4 Minuten Gerätezeit lang.</translation>
    </message>
    <message>
        <source>On top of that it is excited by up to %1°; its speed never changes sign, and the run ends where it comes near zero.</source>
        <translation>Dazu wird er um bis zu %1° angeregt; seine Drehzahl wechselt nie das Vorzeichen, und der Lauf endet, wo sie nahe null kommt.</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 rad/s. The gains on the board stay and are measured with; all else is restored whatever happens.</source>
        <translation>Das Steuergerät beendet die Bewegung bei %1 rad/s. Die Reglerparameter des Steuergeräts bleiben, mit ihnen wird gemessen; alles andere wird in jedem Fall wiederhergestellt.</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>Amplitudenreserve</translation>
    </message>
    <message>
        <source>angle that follows the current at once</source>
        <translation>Winkel, der dem Strom sofort folgt</translation>
    </message>
    <message>
        <source>%1 of %2 frequencies have a coherence of %3 or more; the others are faint and part of no margin and no fit.</source>
        <translation>%1 von %2 Frequenzen haben eine Kohärenz von %3 oder mehr; die anderen sind blass und gehören zu keiner Reserve und keiner Anpassung.</translation>
    </message>
    <message>
        <source>%1 to %2 Hz: amplitude %3°</source>
        <translation>%1 bis %2 Hz: Amplitude %3°</translation>
    </message>
    <message>
        <source>While excited the rotor never turned slower than %1 rad/s.</source>
        <translation>Während der Anregung drehte sich der Rotor nie langsamer als %1 rad/s.</translation>
    </message>
    <message>
        <source>Current up to %1 A, coils up to %2 °C.</source>
        <translation>Strom bis %1 A, Spulen bis %2 °C.</translation>
    </message>
</context>
<context>
    <name>halbench::app::Freshness</name>
    <message>
        <source>No new values since %1</source>
        <translation>Keine neuen Werte seit %1</translation>
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
    <message>
        <source>Gain K</source>
        <translation>Verstärkung K</translation>
    </message>
    <message>
        <source>Integral time T_i</source>
        <translation>Nachstellzeit T_i</translation>
    </message>
    <message>
        <source>Derivative time T_d</source>
        <translation>Vorhaltezeit T_d</translation>
    </message>
    <message>
        <source>Empty: no integral action</source>
        <translation>Leer: kein Integralanteil</translation>
    </message>
    <message>
        <source>Parallel form</source>
        <translation>Parallele Form</translation>
    </message>
    <message>
        <source>Standard form</source>
        <translation>Standardform</translation>
    </message>
    <message>
        <source>Series form</source>
        <translation>Serielle Form</translation>
    </message>
    <message>
        <source>Form of the gains</source>
        <translation>Form der Reglerparameter</translation>
    </message>
    <message>
        <source>Parallel: K_P + K_I/s + K_D s. Standard: K (1 + 1/(T_i s) + T_d s). Series: K (1 + 1/(T_i s))(1 + T_d s). The board and files have the parallel form</source>
        <translation>Parallel: K_P + K_I/s + K_D s. Standard: K (1 + 1/(T_i s) + T_d s). Seriell: K (1 + 1/(T_i s))(1 + T_d s). Steuergerät und Dateien haben die parallele Form</translation>
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
    <message>
        <source>This page is in English only.</source>
        <translation>Diese Seite gibt es nur auf Englisch.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes the help (Ctrl+W; Esc too while nothing is armed and no procedure runs)</source>
        <translation>Schließt die Hilfe (Strg+W; auch Esc, solange nichts freigegeben ist und kein Ablauf läuft)</translation>
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
        <source>F&amp;rom current</source>
        <translation>&amp;Von Strom</translation>
    </message>
    <message>
        <source>T&amp;o current</source>
        <translation>Bis Stro&amp;m</translation>
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
        <source>Given dampi&amp;ng c</source>
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
        <source>Correct it or leave it empty</source>
        <translation>Berichtigen Sie es, oder lassen Sie es leer</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; cannot be used. %3 The field shows %4 A again.</source>
        <translation>%1: „%2“ ist nicht verwendbar. %3 Das Feld zeigt wieder %4 A.</translation>
    </message>
    <message>
        <source>Correct the number</source>
        <translation>Berichtigen Sie die Zahl</translation>
    </message>
    <message>
        <source>It is smaller than &quot;%1&quot;.</source>
        <translation>Er ist kleiner als „%1“.</translation>
    </message>
    <message>
        <source>Make one larger or the other smaller</source>
        <translation>Machen Sie den einen größer oder den anderen kleiner</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
        <translation>Anpassen</translation>
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
    <message>
        <source>Without a given inertia J or torque constant φ only their quotients come out; that is enough for tuning.</source>
        <translation>Ohne gegebenes Trägheitsmoment J oder gegebene Drehmomentkonstante φ ergeben sich nur deren Quotienten; zum Auslegen genügt das.</translation>
    </message>
    <message>
        <source>K_f/φ, friction as a current</source>
        <translation>K_f/φ, Reibung als Strom</translation>
    </message>
    <message>
        <source>K_f/φ is the current that friction takes while the rotor moves. Calibrate finds another figure: the current that starts it from rest, usually more.</source>
        <translation>K_f/φ ist der Strom, den die Reibung braucht, während sich der Rotor dreht. Das Kalibrieren findet eine andere Größe: den Strom, der ihn aus der Ruhe in Gang setzt, meist mehr.</translation>
    </message>
    <message>
        <source>What is the difference?</source>
        <translation>Worin liegt der Unterschied?</translation>
    </message>
    <message>
        <source>in virtual time, without a date</source>
        <translation>in virtueller Zeit, ohne Datum</translation>
    </message>
    <message>
        <source>%1 minutes of device time</source>
        <translation>%1 Minuten Gerätezeit</translation>
    </message>
    <message>
        <source>coils up to %1 °C</source>
        <translation>Spulen bis %1 °C</translation>
    </message>
    <message>
        <source>No device is connected to compare it with.</source>
        <translation>Zum Vergleich ist kein Gerät verbunden.</translation>
    </message>
    <message>
        <source>It is the device that is connected.</source>
        <translation>Es ist das verbundene Gerät.</translation>
    </message>
    <message>
        <source>Connected is another one: %1.</source>
        <translation>Verbunden ist ein anderes: %1.</translation>
    </message>
    <message>
        <source>Good, with the remarks below</source>
        <translation>Gut, mit den Anmerkungen unten</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportForm</name>
    <message>
        <source>as found: %1</source>
        <translation>wie gefunden: %1</translation>
    </message>
    <message>
        <source>not certain</source>
        <translation>nicht sicher</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Trennzeichen</translation>
    </message>
    <message>
        <source>What stands between the columns</source>
        <translation>Was zwischen den Spalten steht</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>Semikolon</translation>
    </message>
    <message>
        <source>tabulator</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>blank</source>
        <translation>Leerzeichen</translation>
    </message>
    <message>
        <source>none, one column</source>
        <translation>keines, eine Spalte</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Dezimalzeichen</translation>
    </message>
    <message>
        <source>What stands before the decimals of a number</source>
        <translation>Was vor den Nachkommastellen einer Zahl steht</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Header</source>
        <translation>Kopfzeilen</translation>
    </message>
    <message>
        <source>What stands above the numbers</source>
        <translation>Was über den Zahlen steht</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>names, then units</source>
        <translation>Namen, dann Einheiten</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>The column of the time, or how many rows were sampled in a second</source>
        <translation>Die Spalte der Zeit, oder wie viele Zeilen in der Sekunde abgetastet wurden</translation>
    </message>
    <message>
        <source>Rows a second</source>
        <translation>Zeilen in der Sekunde</translation>
    </message>
    <message>
        <source>How many rows were sampled in a second</source>
        <translation>Wie viele Zeilen in der Sekunde abgetastet wurden</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>none: rows a second</source>
        <translation>keine: Zeilen in der Sekunde</translation>
    </message>
    <message>
        <source>Say how many rows were sampled in a second.</source>
        <translation>Geben Sie an, wie viele Zeilen in der Sekunde abgetastet wurden.</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportTable</name>
    <message>
        <source>You said this; emptied (Delete), it is as found in the table</source>
        <translation>Das haben Sie gesagt; geleert (Entf) gilt, was in der Tabelle gefunden wurde</translation>
    </message>
    <message>
        <source>First rows as they would be read</source>
        <translation>Erste Zeilen, wie sie gelesen würden</translation>
    </message>
    <message>
        <source>The first rows in the units of the recording; above each what its column becomes</source>
        <translation>Die ersten Zeilen in den Einheiten der Aufzeichnung; darüber, was aus jeder Spalte wird</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Name of column %1</source>
        <translation>Name der Spalte %1</translation>
    </message>
    <message>
        <source>The column of the time is chosen above</source>
        <translation>Die Spalte der Zeit wird oben gewählt</translation>
    </message>
    <message>
        <source>What the recording calls this column: write a name, F2 changes it</source>
        <translation>Wie die Aufzeichnung diese Spalte nennt: Name eintippen, F2 ändert ihn</translation>
    </message>
    <message>
        <source>Unit of column %1</source>
        <translation>Einheit der Spalte %1</translation>
    </message>
    <message>
        <source>What its numbers are written in, for example rpm or mA; a hyphen: no unit</source>
        <translation>Worin ihre Zahlen geschrieben sind, zum Beispiel rpm oder mA; ein Bindestrich: keine Einheit</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportView</name>
    <message>
        <source>Choose table…</source>
        <translation>Tabelle wählen…</translation>
    </message>
    <message>
        <source>A table that another program wrote; the window&apos;s key for it is Ctrl+I</source>
        <translation>Eine Tabelle, die ein anderes Programm geschrieben hat; die Taste des Fensters dafür ist Strg+I</translation>
    </message>
    <message>
        <source>Table that is imported</source>
        <translation>Tabelle, die importiert wird</translation>
    </message>
    <message>
        <source>Name of the recording</source>
        <translation>Name der Aufzeichnung</translation>
    </message>
    <message>
        <source>The recording gets this name, in the folder of the recordings</source>
        <translation>Die Aufzeichnung bekommt diesen Namen, im Ordner der Aufzeichnungen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Reads all rows, writes the recording and shows it</source>
        <translation>Liest alle Zeilen, schreibt die Aufzeichnung und zeigt sie</translation>
    </message>
    <message>
        <source>What is missing for the import</source>
        <translation>Was zum Import fehlt</translation>
    </message>
    <message>
        <source>Choose table</source>
        <translation>Tabelle wählen</translation>
    </message>
    <message>
        <source>Table (*.csv *.txt *.tsv *.dat);;All files (*)</source>
        <translation>Tabelle (*.csv *.txt *.tsv *.dat);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a table first. What of it is not certain is asked here.</source>
        <translation>Wählen Sie zuerst eine Tabelle. Was daran nicht sicher ist, wird hier gefragt.</translation>
    </message>
    <message>
        <source>The table is being read.</source>
        <translation>Die Tabelle wird gelesen.</translation>
    </message>
    <message>
        <source>The table cannot be read like this; above stands why.</source>
        <translation>Die Tabelle lässt sich so nicht lesen; oben steht, warum.</translation>
    </message>
    <message>
        <source>To be answered above: %1.</source>
        <translation>Oben zu beantworten: %1.</translation>
    </message>
    <message>
        <source>The recording needs a name, which is no folder.</source>
        <translation>Die Aufzeichnung braucht einen Namen, der kein Ordner ist.</translation>
    </message>
    <message>
        <source>There is a recording of this name already.</source>
        <translation>Eine Aufzeichnung dieses Namens gibt es schon.</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>Importiert</translation>
    </message>
    <message>
        <source>Importing: %1 rows</source>
        <translation>Importiert: %1 Zeilen</translation>
    </message>
    <message>
        <source>Imported: %1 rows in %2</source>
        <translation>Importiert: %1 Zeilen in %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportWords</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation>Einheit nicht bekannt</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>keine Einheit</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>aus %1</translation>
    </message>
    <message>
        <source>time [s]
by %1 rows a second</source>
        <translation>Zeit [s]
mit %1 Zeilen in der Sekunde</translation>
    </message>
    <message>
        <source>Choose separator, decimal sign, header or time above as they are in the table, or mend the table.</source>
        <translation>Wählen Sie oben Trennzeichen, Dezimalzeichen, Kopfzeilen oder Zeit, wie sie in der Tabelle sind, oder berichtigen Sie die Tabelle.</translation>
    </message>
    <message>
        <source>how columns and numbers are written</source>
        <translation>wie Spalten und Zahlen geschrieben sind</translation>
    </message>
    <message>
        <source>what the first lines are</source>
        <translation>was die ersten Zeilen sind</translation>
    </message>
    <message>
        <source>which column is the time</source>
        <translation>welche Spalte die Zeit ist</translation>
    </message>
    <message>
        <source>there is none: rows a second</source>
        <translation>es gibt keine: Zeilen in der Sekunde</translation>
    </message>
    <message>
        <source>its numbers are in %1</source>
        <translation>ihre Zahlen sind in %1</translation>
    </message>
    <message>
        <source>separator %1</source>
        <translation>Trennzeichen %1</translation>
    </message>
    <message>
        <source>decimal comma</source>
        <translation>Dezimalkomma</translation>
    </message>
    <message>
        <source>decimal point</source>
        <translation>Dezimalpunkt</translation>
    </message>
    <message>
        <source>%1; it reads %2</source>
        <translation>%1; gelesen wird %2</translation>
    </message>
    <message>
        <source>Not certain: %1</source>
        <translation>Nicht sicher: %1</translation>
    </message>
    <message>
        <source>Only you know; nothing is imported before it is answered</source>
        <translation>Das wissen nur Sie; nichts wird importiert, bevor es beantwortet ist</translation>
    </message>
    <message>
        <source>Please choose</source>
        <translation>Bitte wählen</translation>
    </message>
    <message>
        <source>First lines, as they are</source>
        <translation>Erste Zeilen, wie sie sind</translation>
    </message>
    <message>
        <source>Write another name or unit for the column below, or choose another column as the time above.</source>
        <translation>Schreiben Sie unten einen anderen Namen oder eine andere Einheit der Spalte, oder wählen Sie oben eine andere Spalte als Zeit.</translation>
    </message>
    <message>
        <source>Choose the column of the time above, or say there how many rows were sampled in a second; a table that is out of order is to be mended.</source>
        <translation>Wählen Sie oben die Spalte der Zeit, oder geben Sie dort an, wie viele Zeilen in der Sekunde abgetastet wurden; eine Tabelle in falscher Reihenfolge ist zu berichtigen.</translation>
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
    <message>
        <source>link: lost, reconnecting</source>
        <translation>Verbindung: verloren, wird gesucht</translation>
    </message>
</context>
<context>
    <name>halbench::app::LiveHall</name>
    <message>
        <source>Hall B</source>
        <translation>Hall B</translation>
    </message>
    <message>
        <source>Field that the Hall sensors read</source>
        <translation>Feld, das die Hall-Sensoren lesen</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>Hall A</translation>
    </message>
</context>
<context>
    <name>halbench::app::LivePicture</name>
    <message>
        <source>Connect the simulated motor</source>
        <translation>Simulierten Motor verbinden</translation>
    </message>
    <message>
        <source>Save data…</source>
        <translation>Daten speichern…</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>Daten speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>saved: %1</source>
        <translation>gespeichert: %1</translation>
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
    <name>halbench::app::LogPanel</name>
    <message>
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>released</source>
        <translation>gelöst</translation>
    </message>
    <message>
        <source>actuator</source>
        <translation>Aktor</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>started</source>
        <translation>begonnen</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>started: %1</source>
        <translation>begonnen: %1</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>found changed: %1</source>
        <translation>verändert vorgefunden: %1</translation>
    </message>
    <message>
        <source>history</source>
        <translation>Verlauf</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopCapture</name>
    <message>
        <source>capture</source>
        <translation>Erfassung</translation>
    </message>
    <message>
        <source>the device was gone before its capture settings could be put back: unless it was restarted, they are still those of the capture</source>
        <translation>das Gerät war fort, bevor seine Erfassungseinstellungen zurückgestellt werden konnten: Wurde es nicht neu gestartet, sind es noch die der Erfassung</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopFigures</name>
    <message>
        <source>modulus margin</source>
        <translation>Abstand von −1</translation>
    </message>
    <message>
        <source>imaginary part of L</source>
        <translation>Imaginärteil von L</translation>
    </message>
    <message>
        <source>unit circle</source>
        <translation>Einheitskreis</translation>
    </message>
    <message>
        <source>Nyquist plot of the open loop</source>
        <translation>Nyquist-Diagramm des offenen Kreises</translation>
    </message>
    <message>
        <source>real part of L</source>
        <translation>Realteil von L</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>Nichols plot of the open loop</source>
        <translation>Nichols-Diagramm des offenen Kreises</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>sensitivity S</source>
        <translation>Empfindlichkeit S</translation>
    </message>
    <message>
        <source>closed loop T</source>
        <translation>geschlossener Kreis T</translation>
    </message>
    <message>
        <source>Sensitivity and closed loop</source>
        <translation>Empfindlichkeit und geschlossener Kreis</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>measured, not coherent</source>
        <translation>gemessen, nicht kohärent</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopSliders</name>
    <message>
        <source>S&amp;peed</source>
        <translation>Schnelli&amp;gkeit</translation>
    </message>
    <message>
        <source>Speed: gain crossover</source>
        <translation>Schnelligkeit: Durchtrittsfrequenz</translation>
    </message>
    <message>
        <source>Where the open loop has the gain 1: the motor follows up to there. The phase margin is kept as far as it can be. Arrow keys: 2 %, Page up and down: a quarter</source>
        <translation>Wo der offene Kreis die Verstärkung 1 hat: Bis dahin folgt der Motor. Die Phasenreserve bleibt, soweit es geht. Pfeiltasten: 2 %, Bild auf und ab: ein Viertel</translation>
    </message>
    <message>
        <source>&amp;Robustness</source>
        <translation>&amp;Robustheit</translation>
    </message>
    <message>
        <source>Robustness: phase margin</source>
        <translation>Robustheit: Phasenreserve</translation>
    </message>
    <message>
        <source>Phase margin at that crossover, which stays. Arrow keys: 1°, Page up and down: 5°</source>
        <translation>Phasenreserve bei dieser Durchtrittsfrequenz, die bleibt. Pfeiltasten: 1°, Bild auf und ab: 5°</translation>
    </message>
    <message>
        <source>Only %1: the range ends there.</source>
        <translation>Nur %1: Dort endet der Bereich.</translation>
    </message>
    <message>
        <source>Only %1: else K_D is negative.</source>
        <translation>Nur %1: Sonst wird K_D negativ.</translation>
    </message>
    <message>
        <source>Only %1: else it only damps.</source>
        <translation>Nur %1: Sonst dämpft er nur.</translation>
    </message>
    <message>
        <source>Only %1: gain margin %2.</source>
        <translation>Nur %1: Amplitudenreserve %2.</translation>
    </message>
    <message>
        <source>Asked for: %1. The nearest that can be had is taken.</source>
        <translation>Verlangt: %1. Genommen wird das Nächste, das möglich ist.</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopView</name>
    <message>
        <source>Bode</source>
        <translation>Bode</translation>
    </message>
    <message>
        <source>Nyquist</source>
        <translation>Nyquist</translation>
    </message>
    <message>
        <source>Nichols</source>
        <translation>Nichols</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Empfindlichkeit</translation>
    </message>
    <message>
        <source>View of the open loop</source>
        <translation>Ansicht des offenen Kreises</translation>
    </message>
    <message>
        <source>The closed loop is unstable: it has no sensitivity.</source>
        <translation>Der geschlossene Kreis ist instabil: Er hat keine Empfindlichkeit.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Root locus</source>
        <translation>Wurzelortskurve</translation>
    </message>
    <message>
        <source>Bode: magnitude and phase over frequency. Nyquist: the plane around -1. Nichols: magnitude over phase. Sensitivity: what is left of a disturbance, and what follows the reference. Root locus: the poles of the closed loop, and where they go with the gain</source>
        <translation>Bode: Betrag und Phase über der Frequenz. Nyquist: die Ebene um -1. Nichols: Betrag über der Phase. Empfindlichkeit: was von einer Störung bleibt und was der Führungsgröße folgt. Wurzelortskurve: die Pole des geschlossenen Kreises und wohin sie mit der Verstärkung gehen</translation>
    </message>
    <message>
        <source>gain crossover</source>
        <translation>Durchtrittsfrequenz</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>all gains, along the branch</source>
        <translation>alle Reglerparameter, entlang des Astes</translation>
    </message>
    <message>
        <source>Wrap the phase</source>
        <translation>Phase umbrechen</translation>
    </message>
    <message>
        <source>Draw the phase of the Bode plot between -180 and 180 degrees instead of as one line</source>
        <translation>Die Phase des Bode-Diagramms zwischen -180 und 180 Grad zeichnen statt als eine Linie</translation>
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
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>%1 is open in another window.</source>
        <translation>%1 ist in einem anderen Fenster geöffnet.</translation>
    </message>
    <message>
        <source>Close it there, or open a copy as a new project; the file itself stays with the other window.</source>
        <translation>Schließen Sie es dort, oder öffnen Sie eine Kopie als neues Projekt; die Datei selbst bleibt beim anderen Fenster.</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>Kopie öffnen</translation>
    </message>
    <message>
        <source>The autosave of the project could not be read; it was kept as %1.</source>
        <translation>Die automatische Sicherung des Projekts war nicht lesbar; sie liegt unter %1.</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>Projekt speichern unter …</translation>
    </message>
    <message>
        <source>The window stays open, so that what was not saved is not lost.</source>
        <translation>Das Fenster bleibt offen, damit keine ungespeicherte Arbeit verloren geht.</translation>
    </message>
    <message>
        <source>Save the project elsewhere, or close the window without it.</source>
        <translation>Speichern Sie das Projekt an anderer Stelle, oder schließen Sie das Fenster, ohne zu speichern.</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>Trotzdem schließen</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>E&amp;rste Schritte</translation>
    </message>
    <message>
        <source>The program ends as soon as what runs has ended and the actuator is disarmed.</source>
        <translation>Das Programm endet, sobald Laufendes beendet und der Aktor gesperrt ist.</translation>
    </message>
    <message>
        <source>STOP and Esc work until then.</source>
        <translation>STOP und Esc wirken bis dahin.</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>by Esc</source>
        <translation>mit Esc</translation>
    </message>
    <message>
        <source>by STOP of a panel</source>
        <translation>mit STOPP eines Felds</translation>
    </message>
    <message>
        <source>by STOP</source>
        <translation>mit STOPP</translation>
    </message>
    <message>
        <source>by STOP of the help</source>
        <translation>mit STOPP der Hilfe</translation>
    </message>
    <message>
        <source>asked for %1</source>
        <translation>%1 verlangt</translation>
    </message>
    <message>
        <source>project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>saved: %1</source>
        <translation>gespeichert: %1</translation>
    </message>
    <message>
        <source>Take them up</source>
        <translation>Aufgreifen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Import a &amp;table…</source>
        <translation>&amp;Tabelle importieren…</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of %1 are beyond the limits of the preferences and stay for now.</source>
        <translation>
            <numerusform>%n Aufzeichnung aus %1 liegt über den Grenzen der Einstellungen und bleibt vorerst.</numerusform>
            <numerusform>%n Aufzeichnungen aus %1 liegen über den Grenzen der Einstellungen und bleiben vorerst.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody has seen yet what goes from this folder. The preferences show it; nothing goes before.</source>
        <translation>Was aus diesem Ordner ginge, hat noch niemand gesehen. Die Einstellungen zeigen es; vorher geht nichts.</translation>
    </message>
    <message>
        <source>recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>Einstellungen…</translation>
    </message>
    <message>
        <source>What the project says of recordings holds from the next one on.</source>
        <translation>Was das Projekt von Aufzeichnungen sagt, gilt von der nächsten an.</translation>
    </message>
    <message>
        <source>The present one ends as it was begun; saving the project loses nothing of it.</source>
        <translation>Die jetzige endet, wie sie begonnen wurde; beim Speichern des Projekts geht davon nichts verloren.</translation>
    </message>
    <message>
        <source>Plots are shown as usual where the project says what cannot be: %1</source>
        <translation>Diagramme sind wie gewöhnlich, wo das Projekt sagt, was nicht sein kann: %1</translation>
    </message>
    <message>
        <source>The file keeps these lines until the project is saved.</source>
        <translation>Die Datei behält diese Zeilen, bis das Projekt gespeichert wird.</translation>
    </message>
    <message>
        <source>%1 has unsaved work of an earlier session.</source>
        <translation>%1 hat ungespeicherte Arbeit einer früheren Sitzung.</translation>
    </message>
    <message>
        <source>Opening the project takes it up again.</source>
        <translation>Öffnen Sie das Projekt, um sie fortzusetzen.</translation>
    </message>
    <message>
        <source>Open the project</source>
        <translation>Projekt öffnen</translation>
    </message>
</context>
<context>
    <name>halbench::app::ModeBox</name>
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
D-axis: current that holds the rotor without turning it (%1)</source>
        <translation>Leerlauf: kein Strom. Strom: Drehmoment von Hand. Position: hält und folgt.
D-Achse: Strom, der den Rotor hält, ohne ihn zu drehen (%1)</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorCapture</name>
    <message>
        <source>This board cannot capture by itself.</source>
        <translation>Dieses Steuergerät kann nicht selbst aufnehmen.</translation>
    </message>
    <message>
        <source>%1 at %2 Hz, %3 s from %4 s before the event</source>
        <translation>%1 mit %2 Hz, %3 s ab %4 s vor dem Ereignis</translation>
    </message>
    <message>
        <source>Held back</source>
        <translation>Zurückgestellt</translation>
    </message>
    <message>
        <source>A procedure has the device; the board&apos;s capture goes on after it</source>
        <translation>Ein Ablauf hat das Gerät; die Aufnahme des Steuergeräts geht danach weiter</translation>
    </message>
    <message>
        <source>Begins</source>
        <translation>Beginnt</translation>
    </message>
    <message>
        <source>The board is set up to capture %1</source>
        <translation>Das Steuergerät wird eingestellt auf %1</translation>
    </message>
    <message>
        <source>Fills</source>
        <translation>Füllt</translation>
    </message>
    <message>
        <source>The board captures what lies before the event: %1</source>
        <translation>Das Steuergerät nimmt auf, was vor dem Ereignis liegt: %1</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>The board waits until %1; captures %2</source>
        <translation>Das Steuergerät wartet, bis %1; nimmt auf: %2</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>Ausgelöst</translation>
    </message>
    <message>
        <source>The event came; the board captures what follows</source>
        <translation>Das Ereignis kam; das Steuergerät nimmt auf, was folgt</translation>
    </message>
    <message>
        <source>Caught</source>
        <translation>Gefangen</translation>
    </message>
    <message>
        <source>Caught; it is read when the recording is over, so that no row is lost</source>
        <translation>Gefangen; es wird gelesen, wenn die Aufzeichnung vorbei ist, damit keine Zeile verloren geht</translation>
    </message>
    <message>
        <source>Reads, %1 %</source>
        <translation>Liest, %1 %</translation>
    </message>
    <message>
        <source>Reads the capture from the board, %1 %</source>
        <translation>Liest die Aufnahme aus dem Steuergerät, %1 %</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Stopped after an event; Shift+T waits again; %1</source>
        <translation>Angehalten nach einem Ereignis; Umschalt+T wartet erneut; %1</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorData</name>
    <message>
        <source>Copy data</source>
        <translation>Daten kopieren</translation>
    </message>
    <message>
        <source>Copy the samples in view, or between the cursors, as a table</source>
        <translation>Die Messwerte im Bild oder zwischen den Cursorn als Tabelle kopieren</translation>
    </message>
    <message>
        <source>Save data…</source>
        <translation>Daten speichern …</translation>
    </message>
    <message>
        <source>Save the samples in view, or between the cursors, as CSV, MDF4 or MAT</source>
        <translation>Die Messwerte im Bild oder zwischen den Cursorn als CSV, MDF4 oder MAT speichern</translation>
    </message>
    <message>
        <source>Copied: %1 rows</source>
        <translation>Kopiert: %1 Zeilen</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>Daten speichern</translation>
    </message>
    <message>
        <source>plots.csv</source>
        <translation>diagramme.csv</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4 *.mat)</source>
        <translation>Aufzeichnung (*.csv *.mf4 *.mat)</translation>
    </message>
    <message>
        <source>Saved: %1 rows in %2</source>
        <translation>Gespeichert: %1 Zeilen in %2</translation>
    </message>
    <message>
        <source>; on another time axis and not in it: %1</source>
        <translation>; auf einer anderen Zeitachse und nicht darin: %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorForecast</name>
    <message>
        <source>the load has been steady for %1 of the %2 s that are needed</source>
        <translation>die Last ist seit %1 von nötigen %2 s gleich</translation>
    </message>
    <message>
        <source>the temperature has not changed by one step of its sensor</source>
        <translation>die Temperatur hat sich nicht um eine Stufe ihres Sensors geändert</translation>
    </message>
    <message>
        <source>the temperature does not go as it does at a steady load</source>
        <translation>die Temperatur verläuft nicht wie bei gleichbleibender Last</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 reaches %2 in %3 (95 %: %4 to %5) at this load.</source>
        <translation>%1 erreicht %2 bei dieser Last in %3 (95 %: %4 bis %5).</translation>
    </message>
    <message>
        <source>%1 does not reach %2 at this load: it goes to %3 to %4 °C.</source>
        <translation>%1 erreicht %2 bei dieser Last nicht: Sie stellt sich auf %3 bis %4 °C ein.</translation>
    </message>
    <message>
        <source>%1 does not reach %2 at this load.</source>
        <translation>%1 erreicht %2 bei dieser Last nicht.</translation>
    </message>
    <message>
        <source>%1 does not reach %2 for %3 at this load; whether at all is not known yet.</source>
        <translation>%1 erreicht %2 bei dieser Last nicht vor %3; ob überhaupt, ist noch nicht bekannt.</translation>
    </message>
    <message>
        <source>%1 is at its limit of %2.</source>
        <translation>%1 ist an ihrem Grenzwert von %2.</translation>
    </message>
    <message>
        <source>Time to %1 not known: %2.</source>
        <translation>Zeit bis %1 nicht bekannt: %2.</translation>
    </message>
    <message>
        <source>Time until the coils reach their limit</source>
        <translation>Zeit, bis die Spulen ihren Grenzwert erreichen</translation>
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
        <source>Signals of the project that this device does not have: %1</source>
        <translation>Signale aus dem Projekt, die dieses Gerät nicht hat: %1</translation>
    </message>
    <message>
        <source>They are left out; the project keeps them until you change the plots.</source>
        <translation>Sie sind weggelassen; das Projekt behält sie, bis Sie die Diagramme ändern.</translation>
    </message>
    <message>
        <source>Nothing to watch yet</source>
        <translation>Noch nichts zu beobachten</translation>
    </message>
    <message>
        <source>Shows what a connected device measures, live. Choose a device at the left, or try the simulated motor.</source>
        <translation>Zeigt live, was ein verbundenes Gerät misst. Wählen Sie links ein Gerät, oder probieren Sie den simulierten Motor aus.</translation>
    </message>
    <message>
        <source>Connect the simulated motor</source>
        <translation>Simulierten Motor verbinden</translation>
    </message>
    <message>
        <source>Not shown: %1</source>
        <translation>Nicht gezeigt: %1</translation>
    </message>
    <message>
        <source>The device samples them at other moments than the rest, or at none that repeat. Plot signals of one event together.</source>
        <translation>Das Gerät tastet sie zu anderen Zeitpunkten ab als die übrigen oder zu keinen, die sich wiederholen. Signale eines Ereignisses gemeinsam zeichnen.</translation>
    </message>
    <message>
        <source>Not in the running recording: %1</source>
        <translation>Nicht in der laufenden Aufzeichnung: %1</translation>
    </message>
    <message>
        <source>They are added when the recording has ended; until then the stream stays as it is, so that the recording has no gap.</source>
        <translation>Sie kommen dazu, wenn die Aufzeichnung beendet ist; bis dahin bleibt der Datenstrom, wie er ist, sodass die Aufzeichnung keine Lücke hat.</translation>
    </message>
    <message>
        <source>Plot fewer signals.</source>
        <translation>Zeichnen Sie weniger Signale.</translation>
    </message>
    <message>
        <source>The markers are not kept: %1</source>
        <translation>Die Marken werden nicht behalten: %1</translation>
    </message>
    <message>
        <source>Signal to plot</source>
        <translation>Zu zeichnendes Signal</translation>
    </message>
    <message>
        <source>Plots the signal that is chosen (Insert)</source>
        <translation>Zeichnet das gewählte Signal (Einfg)</translation>
    </message>
    <message>
        <source>Units of the project that do not fit their signals: %1</source>
        <translation>Einheiten des Projekts, die nicht zu ihren Signalen passen: %1</translation>
    </message>
    <message>
        <source>They are shown as in the preferences; choose others in the legend (U). The project keeps them until you change the plots.</source>
        <translation>Sie werden wie in den Einstellungen gezeigt; wählen Sie andere in der Legende (U). Das Projekt behält sie, bis Sie die Diagramme ändern.</translation>
    </message>
    <message>
        <source>What is shown may not be what was recorded.</source>
        <translation>Was gezeigt wird, ist vielleicht nicht das, was aufgezeichnet wurde.</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorPicture</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copy the plots as a picture</source>
        <translation>Kopiert die Diagramme als Bild</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Save the plots as SVG, PDF or PNG</source>
        <translation>Speichert die Diagramme als SVG, PDF oder PNG</translation>
    </message>
    <message>
        <source>Plots of %1</source>
        <translation>Kurven von %1</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>plots.svg</source>
        <translation>diagramme.svg</translation>
    </message>
    <message>
        <source>Picture (*.svg *.pdf *.png)</source>
        <translation>Bild (*.svg *.pdf *.png)</translation>
    </message>
    <message>
        <source>%1, reference</source>
        <translation>%1, Referenz</translation>
    </message>
    <message>
        <source>Pictures in the window&apos;s colours</source>
        <translation>Bilder in den Farben des Fensters</translation>
    </message>
    <message>
        <source>Otherwise they are light, for paper and documents</source>
        <translation>Sonst sind sie hell, für Papier und Dokumente</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorRate</name>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Live rate</source>
        <translation>Live-Rate</translation>
    </message>
    <message>
        <source>More rows per second for the plots, as many as the device and its link carry</source>
        <translation>Mehr Zeilen je Sekunde für die Diagramme, so viele, wie Gerät und Verbindung tragen</translation>
    </message>
    <message>
        <source>What is plotted cannot come at %1; it comes at %2, the most that the device and its link carry.</source>
        <translation>Was gezeichnet wird, kann nicht mit %1 kommen; es kommt mit %2, dem Höchsten, das Gerät und Verbindung tragen.</translation>
    </message>
    <message>
        <source>As usual, %1</source>
        <translation>Wie gewöhnlich, %1</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Wie gewöhnlich</translation>
    </message>
    <message>
        <source>The device and its link carry no more</source>
        <translation>Gerät und Verbindung tragen nicht mehr</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorRecording</name>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Showing %1</source>
        <translation>%1 wird angezeigt</translation>
    </message>
    <message>
        <source>Cancelled: the plots show the first %1 s of %2 s.</source>
        <translation>Abgebrochen: Die Diagramme zeigen die ersten %1 s von %2 s.</translation>
    </message>
    <message>
        <source>recording of %1 s</source>
        <translation>Aufzeichnung von %1 s</translation>
    </message>
    <message>
        <source>no signals</source>
        <translation>keine Signale</translation>
    </message>
    <message>
        <source>time passes only while a procedure runs</source>
        <translation>Zeit vergeht nur, solange ein Vorgang läuft</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s), %1 Hz, rows lost: %2</source>
        <translation>
            <numerusform>%n Signal, %1 Hz, Zeilen verloren: %2</numerusform>
            <numerusform>%n Signale, %1 Hz, Zeilen verloren: %2</numerusform>
        </translation>
    </message>
    <message>
        <source>The markers are not kept: %1</source>
        <translation>Die Marken werden nicht behalten: %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorReference</name>
    <message>
        <source>Reference from a recording…</source>
        <translation>Referenz aus einer Aufzeichnung …</translation>
    </message>
    <message>
        <source>Lay a recording under the curves, aligned at the trigger or at the beginning</source>
        <translation>Eine Aufzeichnung unter die Kurven legen, am Trigger oder am Anfang ausgerichtet</translation>
    </message>
    <message>
        <source>Reference from a recording</source>
        <translation>Referenz aus einer Aufzeichnung</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4)</source>
        <translation>Aufzeichnung (*.csv *.mf4)</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Faint curves below the live ones: keep what is shown (K), a recording (Ctrl+K), none (Shift+K)</source>
        <translation>Blasse Kurven unter den laufenden: das Gezeigte behalten (K), eine Aufnahme (Strg+K), keine (Umschalt+K)</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorStatistics</name>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Smallest, largest, mean, rms and spread of what is in view or between the cursors (S)</source>
        <translation>Kleinster und größter Wert, Mittel, Effektivwert und Streuung des Sichtbaren oder zwischen den Messmarken (S)</translation>
    </message>
    <message>
        <source>In view, %1 s</source>
        <translation>Im Bild, %1 s</translation>
    </message>
    <message>
        <source>In view of each plot</source>
        <translation>Im Bild jedes Diagramms</translation>
    </message>
    <message>
        <source>Reading the disk</source>
        <translation>Datenträger wird gelesen</translation>
    </message>
    <message>
        <source>A to B, %1 s</source>
        <translation>A bis B, %1 s</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorTrigger</name>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Oscilloscope: show the time around the newest event until the next one</source>
        <translation>Oszilloskop: zeigt die Zeit um das neueste Ereignis bis zum nächsten</translation>
    </message>
    <message>
        <source>Wait again</source>
        <translation>Erneut warten</translation>
    </message>
    <message>
        <source>Forget what was seen and wait for the next event</source>
        <translation>Vergisst das Gesehene und wartet auf das nächste Ereignis</translation>
    </message>
    <message>
        <source>No samples of %1 come</source>
        <translation>Von %1 kommen keine Werte</translation>
    </message>
    <message>
        <source>Waiting until %1</source>
        <translation>Wartet, bis %1</translation>
    </message>
    <message>
        <source>Triggered; the window is not over yet</source>
        <translation>Ausgelöst; das Fenster ist noch nicht zu Ende</translation>
    </message>
    <message>
        <source>Auto: no event, shown by itself; waiting until %1</source>
        <translation>Auto: kein Ereignis, von selbst gezeigt; wartet, bis %1</translation>
    </message>
    <message>
        <source>Triggered at %1 s; waiting for the next</source>
        <translation>Ausgelöst bei %1 s; wartet auf das nächste</translation>
    </message>
    <message>
        <source>Stopped after the event at %1 s; Shift+T waits again</source>
        <translation>Angehalten nach dem Ereignis bei %1 s; Umschalt+T wartet erneut</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>Keine Messwerte</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>Ausgelöst</translation>
    </message>
    <message>
        <source>Auto: no event</source>
        <translation>Auto: kein Ereignis</translation>
    </message>
    <message>
        <source>Triggered at %1 s</source>
        <translation>Ausgelöst bei %1 s</translation>
    </message>
    <message>
        <source>Stopped at %1 s</source>
        <translation>Angehalten bei %1 s</translation>
    </message>
</context>
<context>
    <name>halbench::app::NoteLabel</name>
    <message>
        <source>Opens the help (Tab, Return)</source>
        <translation>Öffnet die Hilfe (Tab, Eingabe)</translation>
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
    <name>halbench::app::NumberCheck</name>
    <message>
        <source>%1: &apos;%2&apos; cannot be used, nothing moves.</source>
        <translation>%1: „%2“ ist nicht verwendbar; es bewegt sich nichts.</translation>
    </message>
    <message>
        <source>The field shows %1 again.</source>
        <translation>Das Feld zeigt wieder %1.</translation>
    </message>
</context>
<context>
    <name>halbench::app::PaceRow</name>
    <message>
        <source>Simulated &amp;time</source>
        <translation>Simulierte &amp;Zeit</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Simulierte Zeit</translation>
    </message>
    <message>
        <source>Speed of simulated time</source>
        <translation>Geschwindigkeit der simulierten Zeit</translation>
    </message>
    <message>
        <source>How fast the simulated motor lives, or a recording is played: at 20 times a run of two minutes takes six seconds, 100 times slower a step of 50 ms takes five.
In the Monitor &lt; and &gt; change it. A real device has its own time.</source>
        <translation>Wie schnell der simulierte Motor lebt oder eine Aufzeichnung abgespielt wird: Bei 20-fach dauert ein Lauf von zwei Minuten sechs Sekunden, 100-mal langsamer ein Sprung von 50 ms fünf.
Im Monitor ändern &lt; und &gt; sie. Ein wirkliches Gerät hat seine eigene Zeit.</translation>
    </message>
</context>
<context>
    <name>halbench::app::PaceSteps</name>
    <message>
        <source>as fast as possible</source>
        <translation>so schnell wie möglich</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>%1 times slower</source>
        <translation>%1-mal langsamer</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-fach</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Simulated or replayed time runs slower</source>
        <translation>Simulierte oder abgespielte Zeit läuft langsamer</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Simulated or replayed time runs faster</source>
        <translation>Simulierte oder abgespielte Zeit läuft schneller</translation>
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
        <source>Parameters that can only be read: %1.</source>
        <translation>Parameter, die sich nur lesen lassen: %1.</translation>
    </message>
    <message>
        <source>The device takes no writes to them or to the page that it runs on.</source>
        <translation>Das Gerät nimmt für sie oder für die Seite, auf der es läuft, kein Schreiben an.</translation>
    </message>
    <message>
        <source>This device cannot switch a whole set: values that do not lie side by side changed one by one.</source>
        <translation>Dieses Gerät kann keinen ganzen Satz umschalten: Werte, die nicht nebeneinander liegen, haben sich einzeln geändert.</translation>
    </message>
    <message>
        <source>Saves the edited column as a preset of this name (Enter)</source>
        <translation>Speichert die bearbeitete Spalte als Parametersatz dieses Namens (Eingabetaste)</translation>
    </message>
    <message>
        <source>Save preset</source>
        <translation>Satz speichern</translation>
    </message>
    <message>
        <source>Saves the edited column as a preset of this name (Enter in the name)</source>
        <translation>Speichert die bearbeitete Spalte als Parametersatz dieses Namens (Eingabetaste im Namen)</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Save the values as a preset, or serve the device to have one that lasts.</source>
        <translation>Speichern Sie die Werte als Parametersatz, oder stellen Sie das Gerät mit „serve“ bereit, damit es bleibt.</translation>
    </message>
    <message>
        <source>Preset saved as %1.</source>
        <translation>Parametersatz als %1 gespeichert.</translation>
    </message>
</context>
<context>
    <name>halbench::app::PerspectiveBar</name>
    <message>
        <source>Arrange the panels for %1 (%2)</source>
        <translation>Bereiche zum %1 anordnen (%2)</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Arrange the panels for another task (Ctrl+1 to Ctrl+5)</source>
        <translation>Die Bereiche für eine andere Aufgabe anordnen (Strg+1 bis Strg+5)</translation>
    </message>
</context>
<context>
    <name>halbench::app::PlotRows</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>halbench::app::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>Farben des Fensters</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>wie das System</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>Language of the window; files stay as they are</source>
        <translation>Sprache des Fensters; Dateien bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>&amp;Angles in</source>
        <translation>&amp;Winkel in</translation>
    </message>
    <message>
        <source>Unit of measured angles; files are always in SI units</source>
        <translation>Einheit gemessener Winkel; Dateien sind immer in SI-Einheiten</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>Radiant</translation>
    </message>
    <message>
        <source>&amp;Speeds in</source>
        <translation>&amp;Drehzahlen in</translation>
    </message>
    <message>
        <source>Unit of measured speeds; files are always in SI units</source>
        <translation>Einheit gemessener Drehzahlen; Dateien sind immer in SI-Einheiten</translation>
    </message>
    <message>
        <source>revolutions per minute</source>
        <translation>Umdrehungen je Minute</translation>
    </message>
    <message>
        <source>degrees per second</source>
        <translation>Grad je Sekunde</translation>
    </message>
    <message>
        <source>radians per second</source>
        <translation>Radiant je Sekunde</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Lock-out after a stop</source>
        <translation>Sperrzeit nach einem Stopp</translation>
    </message>
    <message>
        <source>After a stop, so long re-arming is refused</source>
        <translation>So lange wird nach einem Stopp das Aufheben abgelehnt</translation>
    </message>
    <message>
        <source>Lock-&amp;out after a stop</source>
        <translation>Sperr&amp;zeit nach einem Stopp</translation>
    </message>
    <message>
        <source>Use what is chosen (Enter)</source>
        <translation>Die Auswahl übernehmen (Eingabe)</translation>
    </message>
    <message>
        <source>Leave all as it was (Esc, which stops too)</source>
        <translation>Alles lassen, wie es war (Esc, das auch stoppt)</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>History on the disk, at most</source>
        <translation>Verlauf auf dem Datenträger, höchstens</translation>
    </message>
    <message>
        <source>So much of the disk this window takes for samples that memory has no room for; beyond it the oldest go first. 4 GB of the disk stay free in any case. A smaller limit is reached as samples come; recordings are not concerned</source>
        <translation>So viel des Datenträgers nimmt dieses Fenster für Messwerte, für die im Speicher kein Platz ist; darüber hinaus gehen die ältesten zuerst. 4 GB des Datenträgers bleiben in jedem Fall frei. Eine kleinere Grenze wird erreicht, wenn Messwerte kommen; Aufzeichnungen sind nicht betroffen</translation>
    </message>
    <message>
        <source>used: %1 GB</source>
        <translation>belegt: %1 GB</translation>
    </message>
    <message>
        <source>History on the disk now</source>
        <translation>Verlauf auf dem Datenträger jetzt</translation>
    </message>
    <message>
        <source>&amp;History on the disk</source>
        <translation>&amp;Verlauf auf dem Datenträger</translation>
    </message>
    <message>
        <source>&amp;Frequencies in</source>
        <translation>Fre&amp;quenzen in</translation>
    </message>
    <message>
        <source>Unit of the frequency axes of loops and responses; files have Hz</source>
        <translation>Einheit der Frequenzachsen von Kreisen und Frequenzgängen; Dateien haben Hz</translation>
    </message>
    <message>
        <source>hertz</source>
        <translation>Hertz</translation>
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
    <message>
        <source>%1, up to %2 expected during the run</source>
        <translation>%1, im Lauf werden bis zu %2 erwartet</translation>
    </message>
    <message>
        <source>The connection is lost; the device is being looked for</source>
        <translation>Die Verbindung ist verloren; das Gerät wird gesucht</translation>
    </message>
    <message>
        <source>Plug it in again or switch it on</source>
        <translation>Wieder anstecken oder einschalten</translation>
    </message>
    <message>
        <source>Nothing is known of the motor behind this device: it has no profile here</source>
        <translation>Vom Motor hinter diesem Gerät ist nichts bekannt: Es hat hier kein Profil</translation>
    </message>
    <message>
        <source>Watch, record and set it by name in Signals, Record and Parameters</source>
        <translation>In Signale, Aufnahme und Parameter nach Namen beobachten, aufnehmen und einstellen</translation>
    </message>
    <message>
        <source>Press Release, beside the state at the top</source>
        <translation>Drücken Sie „Aufheben“ neben dem Zustand oben</translation>
    </message>
    <message>
        <source>No fault, not stopped</source>
        <translation>Kein Fehler, nicht gestoppt</translation>
    </message>
    <message>
        <source>The stop was released a moment ago</source>
        <translation>Der Stopp wurde eben erst aufgehoben</translation>
    </message>
    <message>
        <source>Look, then start</source>
        <translation>Sehen Sie hin, dann starten Sie</translation>
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
    <message>
        <source>%1 is open here, with changes that are not saved yet.</source>
        <translation>%1 ist hier geöffnet, mit noch nicht gespeicherten Änderungen.</translation>
    </message>
    <message>
        <source>The autosave of the project could not be read; it was kept as %1.</source>
        <translation>Die automatische Sicherung des Projekts war nicht lesbar; sie liegt unter %1.</translation>
    </message>
    <message>
        <source>The project itself is as it was saved.</source>
        <translation>Das Projekt selbst ist so, wie es gespeichert wurde.</translation>
    </message>
    <message>
        <source>This is a copy of %1, a new project without a name.</source>
        <translation>Dies ist eine Kopie von %1, ein neues Projekt ohne Namen.</translation>
    </message>
    <message>
        <source>Save it under a name of its own to keep it.</source>
        <translation>Speichern Sie es unter einem eigenen Namen, um es zu behalten.</translation>
    </message>
    <message>
        <source>%1 is open in another window.</source>
        <translation>%1 ist in einem anderen Fenster geöffnet.</translation>
    </message>
    <message>
        <source>Choose another name, or close the other window.</source>
        <translation>Wählen Sie einen anderen Namen, oder schließen Sie das andere Fenster.</translation>
    </message>
    <message>
        <source>Unnamed project, %1</source>
        <translation>Projekt ohne Namen, %1</translation>
    </message>
    <message>
        <source>No project is opened while the actuator is armed or a procedure runs: a slow disk would hold up Esc.</source>
        <translation>Solange der Aktor freigegeben ist oder ein Vorgang läuft, wird kein Projekt geöffnet: Ein langsamer Datenträger hielte Esc auf.</translation>
    </message>
    <message>
        <source>Disarm it, or wait for the end of the procedure, then open the project.</source>
        <translation>Sperren Sie ihn oder warten Sie das Ende des Vorgangs ab; öffnen Sie dann das Projekt.</translation>
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
        <translation>Reglerparameter</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordButton</name>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>written: %1</source>
        <translation>geschrieben: %1</translation>
    </message>
    <message>
        <source>Record data</source>
        <translation>Daten aufzeichnen</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>Recording to a file; a click ends it (Ctrl+R)</source>
        <translation>Zeichnet in eine Datei auf; ein Klick beendet es (Strg+R)</translation>
    </message>
    <message>
        <source>Record data: write what is measured to a file (Ctrl+R)</source>
        <translation>Daten aufzeichnen: schreibt, was gemessen wird, in eine Datei (Strg+R)</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>The disk does not keep up: rows are missing.</source>
        <translation>Der Datenträger kommt nicht nach: Zeilen fehlen.</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Waiting for the event to record</source>
        <translation>Wartet auf das Ereignis, um aufzuzeichnen</translation>
    </message>
    <message>
        <source>Waiting for the trigger&apos;s event; a click ends the wait (Ctrl+R)</source>
        <translation>Wartet auf das Ereignis des Triggers; ein Klick beendet das Warten (Strg+R)</translation>
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
        <source>Rows per second</source>
        <translation>Zeilen je Sekunde</translation>
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
        <source>Completes the file (Ctrl+R)</source>
        <translation>Schließt die Datei ab (Strg+R)</translation>
    </message>
    <message>
        <source>Writes what is measured to a file (Ctrl+R)</source>
        <translation>Schreibt, was gemessen wird, in eine Datei (Strg+R)</translation>
    </message>
    <message>
        <source>What was measured, with its units; the sidecar beside it has the rest.</source>
        <translation>Was gemessen wurde, mit Einheiten; die Begleitdatei daneben enthält das Übrige.</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>Aufzeichnung starten</translation>
    </message>
    <message>
        <source>%1 (gaps: %2, %3 s)</source>
        <translation>%1 (Lücken: %2, %3 s)</translation>
    </message>
    <message>
        <source>Missing: %1; the sidecar says where.</source>
        <translation>Es fehlen: %1; wo, steht in der Begleitdatei.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) in %1</source>
        <translation>
            <numerusform>%Ln Zeile in %1</numerusform>
            <numerusform>%Ln Zeilen in %1</numerusform>
        </translation>
    </message>
    <message>
        <source>The disk did not keep up with %1 of them.</source>
        <translation>Bei %1 davon kam der Datenträger nicht nach.</translation>
    </message>
    <message>
        <source>The disk does not keep up: rows are missing.</source>
        <translation>Der Datenträger kommt nicht nach: Zeilen fehlen.</translation>
    </message>
    <message>
        <source>Record to another disk or fewer rows per second.</source>
        <translation>Zeichnen Sie auf einen anderen Datenträger oder mit weniger Zeilen pro Sekunde auf.</translation>
    </message>
    <message>
        <source>Time kept before the start</source>
        <translation>Zeit vor dem Beginn</translation>
    </message>
    <message>
        <source>So much from before the start is kept in memory and goes in front; 0: nothing</source>
        <translation>So viel von vor dem Beginn wird im Speicher gehalten und vorangestellt; 0: nichts</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>at the trigger</source>
        <translation>beim Trigger</translation>
    </message>
    <message>
        <source>Start of the recording</source>
        <translation>Beginn der Aufzeichnung</translation>
    </message>
    <message>
        <source>At the trigger: Ctrl+R waits for the event that the Monitor&apos;s trigger is set to (T in the plots shows it)</source>
        <translation>Beim Trigger: Strg+R wartet auf das Ereignis, auf das der Trigger des Monitors eingestellt ist (T in den Diagrammen zeigt ihn)</translation>
    </message>
    <message>
        <source>Time after the trigger</source>
        <translation>Zeit nach dem Trigger</translation>
    </message>
    <message>
        <source>The recording ends by itself so long after the event; 0: by hand</source>
        <translation>Die Aufzeichnung endet so lange nach dem Ereignis von selbst; 0: von Hand</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Davor</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Danach</translation>
    </message>
    <message>
        <source>What the recording waits for</source>
        <translation>Worauf die Aufzeichnung wartet</translation>
    </message>
    <message>
        <source>No samples of what the trigger waits for come.</source>
        <translation>Von dem, worauf der Trigger wartet, kommen keine Werte.</translation>
    </message>
    <message>
        <source>Waiting until %1.</source>
        <translation>Wartet, bis %1.</translation>
    </message>
    <message>
        <source>Begins when %1.</source>
        <translation>Beginnt, wenn %1.</translation>
    </message>
    <message>
        <source>In memory: %1 of %2 s.</source>
        <translation>Im Speicher: %1 von %2 s.</translation>
    </message>
    <message>
        <source>End the wait</source>
        <translation>Warten beenden</translation>
    </message>
    <message>
        <source>Wait for the trigger</source>
        <translation>Auf den Trigger warten</translation>
    </message>
    <message>
        <source>Nothing is recorded (Ctrl+R)</source>
        <translation>Es wird nichts aufgezeichnet (Strg+R)</translation>
    </message>
    <message>
        <source>Records from the trigger&apos;s next event on (Ctrl+R)</source>
        <translation>Zeichnet vom nächsten Ereignis des Triggers an auf (Strg+R)</translation>
    </message>
    <message>
        <source>What {name} is in the name mask %1 (File &gt; Preferences)</source>
        <translation>Was {name} in der Namensmaske %1 ist (Datei &gt; Einstellungen)</translation>
    </message>
    <message>
        <source>Without ending; empty: by the name mask %1 (File &gt; Preferences)</source>
        <translation>Ohne Endung; leer: nach der Namensmaske %1 (Datei &gt; Einstellungen)</translation>
    </message>
    <message>
        <source>At most as many as the device and its link carry</source>
        <translation>Höchstens so viele, wie Gerät und Verbindung tragen</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordedMarkers</name>
    <message>
        <source>marker</source>
        <translation>Marke</translation>
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
    <message>
        <source>What is plotted cannot be recorded at %1 Hz.</source>
        <translation>Was gezeichnet wird, kann nicht mit %1 Hz aufgezeichnet werden.</translation>
    </message>
    <message>
        <source>The device and its link carry at most %1 Hz of it. Choose a lower rate, or plot fewer signals.</source>
        <translation>Gerät und Verbindung tragen davon höchstens %1 Hz. Wählen Sie eine kleinere Rate, oder zeichnen Sie weniger Signale.</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingFields</name>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Names of recordings</source>
        <translation>Namen von Aufzeichnungen</translation>
    </message>
    <message>
        <source>Of recordings without a name of their own: {device}, {date} and {time} (UTC), {number}; {name} is what the Record panel has. The rest stays as it is</source>
        <translation>Von Aufzeichnungen ohne eigenen Namen: {device}, {date} und {time} (UTC), {number}; {name} steht im Bereich Aufnahme. Der Rest bleibt, wie er ist</translation>
    </message>
    <message>
        <source>Example of a recording&apos;s name</source>
        <translation>Beispiel für den Namen einer Aufzeichnung</translation>
    </message>
    <message>
        <source>&amp;Names of recordings</source>
        <translation>&amp;Namen von Aufzeichnungen</translation>
    </message>
    <message>
        <source>Only what the program named itself goes, the oldest first, into the trash; what the trash does not take stays. What has tags, notes or results, is open or less than a day old stays</source>
        <translation>Nur was das Programm selbst benannt hat, geht, das Älteste zuerst, in den Papierkorb; was der Papierkorb nicht nimmt, bleibt. Was Schlagwörter, Notizen oder Ergebnisse hat, offen oder jünger als ein Tag ist, bleibt</translation>
    </message>
    <message>
        <source>at &amp;most</source>
        <translation>&amp;höchstens</translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source>an&amp;d at most</source>
        <translation>&amp;und höchstens</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>Keep recordings for a time</source>
        <translation>Aufzeichnungen eine Zeit lang behalten</translation>
    </message>
    <message>
        <source>Days that recordings are kept</source>
        <translation>Tage, die Aufzeichnungen behalten werden</translation>
    </message>
    <message>
        <source>Limit the disk of recordings</source>
        <translation>Speicherplatz von Aufzeichnungen begrenzen</translation>
    </message>
    <message>
        <source>Disk that recordings take</source>
        <translation>Speicherplatz von Aufzeichnungen</translation>
    </message>
    <message>
        <source>Recordings that would go now</source>
        <translation>Aufzeichnungen, die jetzt gehen würden</translation>
    </message>
    <message>
        <source>Keep recordings</source>
        <translation>Aufzeichnungen behalten</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>e.g. %1.csv</source>
        <translation>z. B. %1.csv</translation>
    </message>
    <message>
        <source>Nothing is ever removed.</source>
        <translation>Es wird nie etwas entfernt.</translation>
    </message>
    <message>
        <source>Looking at what would go …</source>
        <translation>Es wird nachgesehen, was gehen würde …</translation>
    </message>
    <message>
        <source>With OK nothing goes now from %1.</source>
        <translation>Mit OK geht jetzt nichts aus %1.</translation>
    </message>
    <message numerus="yes">
        <source>With OK %n recording(s) go to the trash now (%1), from %2.</source>
        <translation>
            <numerusform>Mit OK geht jetzt %n Aufzeichnung in den Papierkorb (%1), aus %2.</numerusform>
            <numerusform>Mit OK gehen jetzt %n Aufzeichnungen in den Papierkorb (%1), aus %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing goes from %1 for now: %2 is dated after now, so the clock is or was wrong.</source>
        <translation>Aus %1 geht vorerst nichts: %2 ist auf später als jetzt datiert, also geht oder ging die Uhr falsch.</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingPlace</name>
    <message>
        <source>recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>The folder of the last recording, %1, is not there; recordings go to %2.</source>
        <translation>Der Ordner der letzten Aufzeichnung, %1, ist nicht da; Aufzeichnungen gehen nach %2.</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingTidying</name>
    <message>
        <source>recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>not tidied away: %1</source>
        <translation>nicht aufgeräumt: %1</translation>
    </message>
    <message>
        <source>older than the preferences keep</source>
        <translation>älter, als die Einstellungen behalten</translation>
    </message>
    <message>
        <source>no room by the preferences</source>
        <translation>kein Platz nach den Einstellungen</translation>
    </message>
    <message>
        <source>moved to the trash: %1 (%2)</source>
        <translation>in den Papierkorb verschoben: %1 (%2)</translation>
    </message>
    <message>
        <source>nothing is tidied away: %1 is dated after now, so the clock is or was wrong</source>
        <translation>nichts wird aufgeräumt: %1 ist auf später als jetzt datiert, also geht oder ging die Uhr falsch</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingTrigger</name>
    <message>
        <source>the set-point changes</source>
        <translation>sich der Sollwert ändert</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingsPanel</name>
    <message>
        <source>Search recordings</source>
        <translation>Aufzeichnungen suchen</translation>
    </message>
    <message>
        <source>Search name, device, date, signals, tags, notes</source>
        <translation>Name, Gerät, Datum, Signale, Schlagwörter, Notizen suchen</translation>
    </message>
    <message>
        <source>Every word must occur somewhere (Ctrl+F)</source>
        <translation>Jedes Wort muss irgendwo vorkommen (Strg+F)</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Looks into the folder again (F5)</source>
        <translation>Sieht wieder in den Ordner (F5)</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Begin at</source>
        <translation>Beginnen bei</translation>
    </message>
    <message>
        <source>Time of the recording at which it is played; Enter goes there</source>
        <translation>Zeit der Aufzeichnung, ab der abgespielt wird; Eingabe springt dorthin</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Makes a recording of what an interrupted program left</source>
        <translation>Macht aus dem, was ein unterbrochenes Programm hinterließ, eine Aufzeichnung</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Überlagerung</translation>
    </message>
    <message>
        <source>Results over time</source>
        <translation>Ergebnisse über der Zeit</translation>
    </message>
    <message>
        <source>Tags and notes</source>
        <translation>Schlagwörter und Notizen</translation>
    </message>
    <message>
        <source>Tags of the recording</source>
        <translation>Schlagwörter der Aufzeichnung</translation>
    </message>
    <message>
        <source>Tags, with commas between them</source>
        <translation>Schlagwörter, mit Kommas dazwischen</translation>
    </message>
    <message>
        <source>Words to find it again; kept in its sidecar</source>
        <translation>Wörter zum Wiederfinden; stehen in ihrer Begleitdatei</translation>
    </message>
    <message>
        <source>Notes on the recording</source>
        <translation>Notizen zur Aufzeichnung</translation>
    </message>
    <message>
        <source>Notes on this recording</source>
        <translation>Notizen zu dieser Aufzeichnung</translation>
    </message>
    <message>
        <source>Kept in its sidecar</source>
        <translation>Stehen in ihrer Begleitdatei</translation>
    </message>
    <message>
        <source>No recordings in %1 yet. Record data (Ctrl+R) makes one.</source>
        <translation>Noch keine Aufzeichnungen in %1. „Daten aufzeichnen“ (Strg+R) macht eine.</translation>
    </message>
    <message>
        <source>An interrupted recording was recovered: %1 s in %2</source>
        <translation>Eine unterbrochene Aufzeichnung wurde wiederhergestellt: %1 s in %2</translation>
    </message>
    <message>
        <source>Nothing that was written is lost.</source>
        <translation>Nichts Geschriebenes ging verloren.</translation>
    </message>
    <message>
        <source>Lost: %1 octets at its end or damaged.</source>
        <translation>Verloren: %1 Oktette am Ende oder beschädigt.</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>The damaged file is kept as %1.</source>
        <translation>Die beschädigte Datei bleibt als %1.</translation>
    </message>
    <message>
        <source>Enter opens the selected recording; several are laid over each other</source>
        <translation>Eingabe öffnet die gewählte Aufzeichnung; mehrere werden übereinandergelegt</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Shows all of the recording in the panels at once (Enter). The device that is connected is left; not while it is armed, is recorded or works</source>
        <translation>Zeigt die Aufzeichnung auf einmal ganz in den Bereichen (Eingabe). Das verbundene Gerät wird getrennt; nicht, solange es freigegeben ist, aufgezeichnet wird oder arbeitet</translation>
    </message>
    <message>
        <source>Plays the recording in the panels, as if its device were connected (Ctrl+Return). The device that is connected is left; not while it is armed, is recorded or works</source>
        <translation>Spielt die Aufzeichnung in den Bereichen ab, als wäre ihr Gerät verbunden (Strg+Eingabe). Das verbundene Gerät wird getrennt; nicht, solange es freigegeben ist, aufgezeichnet wird oder arbeitet</translation>
    </message>
    <message>
        <source>Overlay, results, tags and notes, import</source>
        <translation>Überlagerung, Ergebnisse, Schlagwörter und Notizen, Import</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>This table is of another program: look below how it is read.</source>
        <translation>Diese Tabelle ist von einem anderen Programm: Sehen Sie unten, wie sie gelesen wird.</translation>
    </message>
    <message>
        <source>Import makes a recording of it; the table stays as it is.</source>
        <translation>Importieren macht eine Aufzeichnung daraus; die Tabelle bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Was wäre wenn</translation>
    </message>
    <message>
        <source>Shows in Tune what the gains proposed there would have made of this move</source>
        <translation>Zeigt in Auslegen, was die dort vorgeschlagenen Reglerparameter aus dieser Bewegung gemacht hätten</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingsTableModel</name>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>%1 (%2 rows)</source>
        <translation>%1 (%2 Zeilen)</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1 (simuliert)</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Schlagwörter</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
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
    <name>halbench::app::RelayForm</name>
    <message>
        <source>&amp;Base speed</source>
        <translation>&amp;Grunddrehzahl</translation>
    </message>
    <message>
        <source>Height of the relay</source>
        <translation>Höhe des Relais</translation>
    </message>
    <message>
        <source>Swings</source>
        <translation>Schwingungen</translation>
    </message>
    <message>
        <source>Steady speed that the loop swings around, at least 3 rad/s in either direction: friction is then a plain offset. Empty: as slow as is safe</source>
        <translation>Gleichmäßige Drehzahl, um die der Kreis schwingt, mindestens 3 rad/s in einer der Richtungen: Reibung ist dann ein bloßer Versatz. Leer: so langsam, wie es sicher ist</translation>
    </message>
    <message>
        <source>Current at which the controller saturates. Empty: as high as is safe</source>
        <translation>Strom, bei dem der Regler in die Begrenzung geht. Leer: so hoch, wie es sicher ist</translation>
    </message>
    <message>
        <source>That are measured, 40 to 400; the intervals shrink with their root. Empty: 100</source>
        <translation>Die gemessen werden, 40 bis 400; die Intervalle schrumpfen mit der Wurzel. Leer: 100</translation>
    </message>
    <message>
        <source>what is safe</source>
        <translation>was sicher ist</translation>
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
    <name>halbench::app::RelayPanel</name>
    <message>
        <source>Save result</source>
        <translation>Ergebnis speichern</translation>
    </message>
    <message>
        <source>Relay experiment (*.json)</source>
        <translation>Relaisversuch (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Schwingen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Lets the loop swing by itself around a steady motion, with proportional control that saturates, and finds the gain at which it would swing for ever, with its 95 % interval. Calibrate the sensors first.</source>
        <translation>Lässt den Kreis von selbst um eine gleichmäßige Bewegung schwingen, mit P-Regelung, die in die Begrenzung geht, und findet die Verstärkung, bei der er für immer schwänge, mit ihrem 95-%-Intervall. Kalibrieren Sie zuerst die Sensoren.</translation>
    </message>
    <message>
        <source>The rotor turns steadily and swings around that. STOP (Esc) and Cancel end it; gains, limits, mode, windows and generator are restored.</source>
        <translation>Der Rotor dreht sich gleichmäßig und schwingt darum. STOPP (Esc) und Abbrechen beenden es; Reglerparameter, Grenzen, Betriebsart, Fenster und Generator werden wiederhergestellt.</translation>
    </message>
    <message>
        <source>Start experiment</source>
        <translation>Versuch starten</translation>
    </message>
    <message>
        <source>The rotor turns and swings (Ctrl+Return); Esc stops it</source>
        <translation>Der Rotor dreht sich und schwingt (Strg+Eingabe); Esc hält ihn an</translation>
    </message>
    <message>
        <source>Use in Tune</source>
        <translation>In Auslegung verwenden</translation>
    </message>
    <message>
        <source>Propose gains by Ziegler and Nichols from it, with their proof; nothing is applied</source>
        <translation>Daraus Reglerparameter nach Ziegler und Nichols vorschlagen, mit ihrem Nachweis; nichts wird übernommen</translation>
    </message>
    <message>
        <source>Save result…</source>
        <translation>Ergebnis speichern…</translation>
    </message>
    <message>
        <source>Write the file that tune --relay reads</source>
        <translation>Die Datei schreiben, die tune --relay liest</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next one</source>
        <translation>Zurück zu den Einstellungen; dieses Ergebnis bleibt bis zum nächsten</translation>
    </message>
    <message>
        <source>The swing as recorded</source>
        <translation>Die Schwingung, wie aufgezeichnet</translation>
    </message>
    <message>
        <source>Ultimate gain and period</source>
        <translation>Kritische Verstärkung und Periode</translation>
    </message>
    <message>
        <source>Relay experiment</source>
        <translation>Relaisversuch</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Misst</translation>
    </message>
    <message>
        <source>Computing the result</source>
        <translation>Berechnet das Ergebnis</translation>
    </message>
    <message>
        <source>The experiment was cancelled; everything is as it was before.</source>
        <translation>Der Versuch wurde abgebrochen; alles ist wie vorher.</translation>
    </message>
</context>
<context>
    <name>halbench::app::RelayWords</name>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>verworfen</translation>
    </message>
    <message>
        <source>The findings above say why, and what helps</source>
        <translation>Die Befunde oben sagen, warum, und was hilft</translation>
    </message>
    <message>
        <source>ultimate gain of the model</source>
        <translation>kritische Verstärkung des Modells</translation>
    </message>
    <message>
        <source>identified motor</source>
        <translation>identifizierter Motor</translation>
    </message>
    <message>
        <source>published motor</source>
        <translation>veröffentlichter Motor</translation>
    </message>
    <message>
        <source>The identified motor agrees: the two intervals overlap.</source>
        <translation>Der identifizierte Motor stimmt überein: die beiden Intervalle überlappen sich.</translation>
    </message>
    <message>
        <source>The identified motor disagrees: the two intervals lie apart.</source>
        <translation>Der identifizierte Motor stimmt nicht überein: die beiden Intervalle liegen auseinander.</translation>
    </message>
    <message>
        <source>Whether a model agrees is not known: identify the motor to compare.</source>
        <translation>Ob ein Modell übereinstimmt, ist nicht bekannt: identifizieren Sie zum Vergleich den Motor.</translation>
    </message>
    <message>
        <source>The rotor will turn in reverse at %1 rad/s (%2 r/min), about %3 turns, for %4 minutes of device time.</source>
        <translation>Der Rotor wird sich rückwärts mit %1 rad/s (%2 1/min) drehen, etwa %3 Umdrehungen, %4 Minuten Gerätezeit lang.</translation>
    </message>
    <message>
        <source>The rotor will turn forward at %1 rad/s (%2 r/min), about %3 turns, for %4 minutes of device time.</source>
        <translation>Der Rotor wird sich vorwärts mit %1 rad/s (%2 1/min) drehen, etwa %3 Umdrehungen, %4 Minuten Gerätezeit lang.</translation>
    </message>
    <message>
        <source>It swings around that by about %1° every %2 s, with speeds from %3 to %4 rad/s; its speed never changes sign, and the run ends where it leaves what is foreseen.</source>
        <translation>Er schwingt darum um etwa %1° alle %2 s, mit Drehzahlen von %3 bis %4 rad/s; seine Drehzahl wechselt nie das Vorzeichen, und der Lauf endet, wo sie das Vorhergesehene verlässt.</translation>
    </message>
    <message>
        <source>Current up to %1 A, coils up to %2 °C.</source>
        <translation>Strom bis %1 A, Spulen bis %2 °C.</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 rad/s at the latest. Its gains and limits are replaced for the experiment and restored whatever happens.</source>
        <translation>Das Steuergerät beendet die Bewegung spätestens bei %1 rad/s. Seine Reglerparameter und Grenzen werden für den Versuch ersetzt und in jedem Fall wiederhergestellt.</translation>
    </message>
    <message>
        <source>ultimate gain</source>
        <translation>kritische Verstärkung</translation>
    </message>
    <message>
        <source>ultimate period</source>
        <translation>kritische Periode</translation>
    </message>
    <message>
        <source>phase where it swung</source>
        <translation>Phase, bei der er schwang</translation>
    </message>
    <message>
        <source>at %1 rad/s; followed from there to −180°</source>
        <translation>bei %1 rad/s; von dort bis −180° verfolgt</translation>
    </message>
    <message>
        <source>%1 swings of %2° around the steady motion, with %3 A; their frequency scattered by %4 %.</source>
        <translation>%1 Schwingungen von %2° um die gleichmäßige Bewegung, mit %3 A; ihre Frequenz streute um %4 %.</translation>
    </message>
    <message>
        <source>The speed stayed between %1 and %2 rad/s.</source>
        <translation>Die Drehzahl blieb zwischen %1 und %2 rad/s.</translation>
    </message>
</context>
<context>
    <name>halbench::app::RestRippleWords</name>
    <message>
        <source>at rest the current ripples by about %1 A: that is the noise of the measured angle (%2) times these gains, while friction holds the rotor still</source>
        <translation>in Ruhe schwankt der Strom um etwa %1 A: das ist das Rauschen des gemessenen Winkels (%2) mal diesen Reglerparametern, während Reibung den Rotor festhält</translation>
    </message>
    <message>
        <source>at rest the current ripples by about %1 A, more than the noise of the measured angle (%2) explains: the loop may hunt; a smaller K_D or K_P calms it</source>
        <translation>in Ruhe schwankt der Strom um etwa %1 A, mehr als das Rauschen des gemessenen Winkels (%2) erklärt: der Regelkreis pendelt vielleicht; weniger K_D oder K_P beruhigt ihn</translation>
    </message>
</context>
<context>
    <name>halbench::app::ResultHistoryView</name>
    <message>
        <source>Damping c</source>
        <translation>Dämpfung c</translation>
    </message>
    <message>
        <source>Friction K_f</source>
        <translation>Reibung K_f</translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation>Drehmomentkonstante</translation>
    </message>
    <message>
        <source>Inertia J</source>
        <translation>Trägheit J</translation>
    </message>
    <message>
        <source>%1 (given)</source>
        <translation>%1 (vorgegeben)</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>Against the first of this device: more than both intervals explain</source>
        <translation>Gegenüber dem ersten dieses Geräts: mehr, als beide Intervalle erklären</translation>
    </message>
    <message>
        <source>Against the first of this device: within the intervals</source>
        <translation>Gegenüber dem ersten dieses Geräts: innerhalb der Intervalle</translation>
    </message>
    <message>
        <source>simulated time</source>
        <translation>simulierte Zeit</translation>
    </message>
    <message>
        <source>Identified values over time</source>
        <translation>Identifizierte Werte über der Zeit</translation>
    </message>
    <message>
        <source>The identification files (.json) of the folder, oldest first, with 95 % intervals; in brackets the drift since the first of the same device</source>
        <translation>Die Identifikationsdateien (.json) des Ordners, älteste zuerst, mit 95-%-Intervallen; in Klammern die Drift seit der ersten desselben Geräts</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Data quality</source>
        <translation>Datenqualität</translation>
    </message>
</context>
<context>
    <name>halbench::app::ReturnNotice</name>
    <message>
        <source>Values that differ from before</source>
        <translation>Werte, die anders sind als vorher</translation>
    </message>
    <message>
        <source>On the left before the connection was lost, on the right on the device now</source>
        <translation>Links vor dem Abbruch der Verbindung, rechts jetzt im Gerät</translation>
    </message>
    <message>
        <source>Write them back</source>
        <translation>Zurückschreiben</translation>
    </message>
    <message>
        <source>Writes the values of before to the device and reads them back</source>
        <translation>Schreibt die Werte von vorher ins Gerät und liest sie zurück</translation>
    </message>
    <message>
        <source>Keep the device&apos;s</source>
        <translation>Die des Geräts behalten</translation>
    </message>
    <message>
        <source>What is on the device now counts</source>
        <translation>Es gilt, was jetzt im Gerät steht</translation>
    </message>
    <message>
        <source>Looking for it again.</source>
        <translation>Das Gerät wird gesucht.</translation>
    </message>
    <message>
        <source>Looking for it again; last time: %1.</source>
        <translation>Das Gerät wird gesucht; zuletzt: %1.</translation>
    </message>
    <message>
        <source>Connection lost: %1.</source>
        <translation>Verbindung verloren: %1.</translation>
    </message>
    <message>
        <source>Back after %1 s, disarmed.</source>
        <translation>Nach %1 s wieder da, gesperrt.</translation>
    </message>
    <message>
        <source>Back after %1 s, disarmed. Values that differ from before: %2.</source>
        <translation>Nach %1 s wieder da, gesperrt. Werte, die anders sind als vorher: %2.</translation>
    </message>
    <message>
        <source>The device may have been restarted. Nothing was written.</source>
        <translation>Das Gerät wurde vielleicht neu gestartet. Geschrieben wurde nichts.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>The device&apos;s values were kept.</source>
        <translation>Die Werte des Geräts wurden behalten.</translation>
    </message>
    <message>
        <source>The board&apos;s watchdog ends its motion.</source>
        <translation>Der Watchdog des Steuergeräts beendet die Bewegung.</translation>
    </message>
    <message>
        <source>The recording goes on with a gap.</source>
        <translation>Die Aufzeichnung läuft mit einer Lücke weiter.</translation>
    </message>
    <message>
        <source>Disconnect ends the search.</source>
        <translation>„Trennen“ beendet die Suche.</translation>
    </message>
    <message>
        <source>Its values are those of before.</source>
        <translation>Seine Werte sind die von vorher.</translation>
    </message>
    <message>
        <source>The values that differed were changed since.</source>
        <translation>Die abweichenden Werte wurden seither geändert.</translation>
    </message>
    <message>
        <source>Values that differ from before the loss: %1.</source>
        <translation>Werte, die anders sind als vor dem Abbruch: %1.</translation>
    </message>
    <message>
        <source>The values of before were written back.</source>
        <translation>Die Werte von vorher wurden zurückgeschrieben.</translation>
    </message>
</context>
<context>
    <name>halbench::app::RootLocusFigure</name>
    <message>
        <source>damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>gain from 0 to %1 times</source>
        <translation>Verstärkung vom 0- bis zum %1-fachen</translation>
    </message>
    <message>
        <source>imaginary part of z</source>
        <translation>Imaginärteil von z</translation>
    </message>
    <message>
        <source>poles of the open loop</source>
        <translation>Pole des offenen Kreises</translation>
    </message>
    <message>
        <source>zeros</source>
        <translation>Nullstellen</translation>
    </message>
    <message>
        <source>poles of the closed loop</source>
        <translation>Pole des geschlossenen Kreises</translation>
    </message>
    <message>
        <source>real part of z</source>
        <translation>Realteil von z</translation>
    </message>
    <message>
        <source>limit of stability</source>
        <translation>Stabilitätsgrenze</translation>
    </message>
    <message>
        <source>limit at gain factor</source>
        <translation>Grenze bei Faktor</translation>
    </message>
    <message>
        <source>closed loop: %1</source>
        <translation>geschlossener Kreis: %1</translation>
    </message>
    <message>
        <source>Root locus</source>
        <translation>Wurzelortskurve</translation>
    </message>
</context>
<context>
    <name>halbench::app::RunOverlay</name>
    <message>
        <source>Overlay of the selected recordings</source>
        <translation>Überlagerung der gewählten Aufzeichnungen</translation>
    </message>
    <message>
        <source>Values at the cursor</source>
        <translation>Werte am Cursor</translation>
    </message>
    <message>
        <source>What each recording has at the time of the cursor</source>
        <translation>Was jede Aufzeichnung zur Zeit des Cursors hat</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>At the cursor</source>
        <translation>Am Cursor</translation>
    </message>
    <message>
        <source>Signals that all selected recordings have</source>
        <translation>Signale, die alle gewählten Aufzeichnungen haben</translation>
    </message>
    <message>
        <source>What is at time zero: the first row, the trigger, or a marker that all of them have</source>
        <translation>Was bei Zeit null liegt: die erste Zeile, der Auslöser oder eine Marke, die alle haben</translation>
    </message>
    <message>
        <source>Time of the cursor</source>
        <translation>Zeit des Cursors</translation>
    </message>
    <message>
        <source>The line in the plot and the values beside it</source>
        <translation>Die Linie im Diagramm und die Werte daneben</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Aligned at</source>
        <translation>Ausgerichtet an</translation>
    </message>
    <message>
        <source>Cursor</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Signal that is compared</source>
        <translation>Verglichenes Signal</translation>
    </message>
    <message>
        <source>Moment at which they are aligned</source>
        <translation>Augenblick, an dem sie ausgerichtet sind</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>All of it, or so much about the cursor</source>
        <translation>Alles, oder so viel um den Cursor</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>%1 s about the cursor</source>
        <translation>%1 s um den Cursor</translation>
    </message>
    <message>
        <source>%1 recordings are laid over each other at most</source>
        <translation>Höchstens %1 Aufzeichnungen werden übereinandergelegt</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>trigger</source>
        <translation>Auslöser</translation>
    </message>
    <message>
        <source>marker: %1</source>
        <translation>Marke: %1</translation>
    </message>
    <message>
        <source>Select recordings in the list: their curves are drawn over each other here.</source>
        <translation>Wählen Sie Aufzeichnungen in der Liste: ihre Kurven werden hier übereinander gezeichnet.</translation>
    </message>
    <message>
        <source>These recordings have nothing in common there: choose another signal, moment or time.</source>
        <translation>Diese Aufzeichnungen haben dort nichts gemeinsam: Wählen Sie ein anderes Signal, einen anderen Bezugspunkt oder eine andere Zeit.</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Compare it with a copy of it: it may lack rows, or have others.</source>
        <translation>Vergleichen Sie sie mit einer Kopie: Ihr können Zeilen fehlen, oder sie hat andere.</translation>
    </message>
</context>
<context>
    <name>halbench::app::ShownRecording</name>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
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
    <message>
        <source>Last</source>
        <translation>Zuletzt</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrogramFigure</name>
    <message>
        <source>Spectrogram of %1</source>
        <translation>Spektrogramm von %1</translation>
    </message>
    <message>
        <source>Lines every %1 Hz, resolution %2 Hz, segments of %3 s</source>
        <translation>Linien alle %1 Hz, Auflösung %2 Hz, Abschnitte von %3 s</translation>
    </message>
    <message>
        <source>one every %1 s</source>
        <translation>einer alle %1 s</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrogramRange</name>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Lowest [Hz]</source>
        <translation>Unterste [Hz]</translation>
    </message>
    <message>
        <source>The lowest frequency shown; empty: all</source>
        <translation>Die unterste gezeigte Frequenz; leer: alle</translation>
    </message>
    <message>
        <source>Highest [Hz]</source>
        <translation>Oberste [Hz]</translation>
    </message>
    <message>
        <source>The highest frequency shown; empty: all</source>
        <translation>Die oberste gezeigte Frequenz; leer: alle</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>Farben von</translation>
    </message>
    <message>
        <source>The value of the darkest colour, in the unit of the scale; empty: by what is shown</source>
        <translation>Der Wert der dunkelsten Farbe, in der Einheit der Skala; leer: nach dem, was gezeigt wird</translation>
    </message>
    <message>
        <source>Colours to</source>
        <translation>Farben bis</translation>
    </message>
    <message>
        <source>The value of the brightest colour, in the unit of the scale; empty: by what is shown</source>
        <translation>Der Wert der hellsten Farbe, in der Einheit der Skala; leer: nach dem, was gezeigt wird</translation>
    </message>
    <message>
        <source>The lowest frequency must be below the highest; all are shown.</source>
        <translation>Die unterste Frequenz muss unter der obersten liegen; alle werden gezeigt.</translation>
    </message>
    <message>
        <source>The colours must begin below their end; they follow what is shown.</source>
        <translation>Die Farben müssen unter ihrem Ende beginnen; sie folgen dem, was gezeigt wird.</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrumFigure</name>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>rms value</source>
        <translation>Effektivwert</translation>
    </message>
    <message>
        <source>power density</source>
        <translation>Leistungsdichte</translation>
    </message>
    <message>
        <source>amplitude density</source>
        <translation>Amplitudendichte</translation>
    </message>
    <message>
        <source>Spectrum of %1</source>
        <translation>Spektrum von %1</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Lines every %1 Hz, resolution %2 Hz, segments of %3 s</source>
        <translation>Linien alle %1 Hz, Auflösung %2 Hz, Abschnitte von %3 s</translation>
    </message>
    <message>
        <source>95 % interval of noise: %1 to %2 times the line</source>
        <translation>95-%-Bereich bei Rauschen: das %1- bis %2-Fache der Linie</translation>
    </message>
    <message>
        <source>rms of all lines %1 %2</source>
        <translation>Effektivwert aller Linien %1 %2</translation>
    </message>
    <message>
        <source>no segment reaches across the %1 gaps and %2 missing values</source>
        <translation>kein Abschnitt reicht über die %1 Lücken und %2 fehlenden Werte</translation>
    </message>
    <message numerus="yes">
        <source>%Ln average(s)</source>
        <translation>
            <numerusform>%Ln Mittelung</numerusform>
            <numerusform>%Ln Mittelungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (worth %2 independent ones)</source>
        <translation>%1 (so gut wie %2 unabhängige)</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrumPanel</name>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Rectangular</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Flat top</source>
        <translation>Flat-Top</translation>
    </message>
    <message>
        <source>Nothing to analyse yet</source>
        <translation>Noch nichts zu analysieren</translation>
    </message>
    <message>
        <source>Shows which frequencies are in a signal of a connected device, live. Choose a device at the left, or try the simulated motor.</source>
        <translation>Zeigt laufend, welche Frequenzen in einem Signal eines verbundenen Geräts stecken. Wählen Sie links ein Gerät oder probieren Sie den simulierten Motor.</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Log frequency</source>
        <translation>Frequenz log.</translation>
    </message>
    <message>
        <source>Logarithmic axis of the frequency</source>
        <translation>Logarithmische Achse der Frequenz</translation>
    </message>
    <message>
        <source>Log values</source>
        <translation>Werte log.</translation>
    </message>
    <message>
        <source>Logarithmic axis of the values</source>
        <translation>Logarithmische Achse der Werte</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Keep the spectrum as it is; the data go on</source>
        <translation>Das Spektrum bleibt, wie es ist; die Daten laufen weiter</translation>
    </message>
    <message>
        <source>The arrow keys walk along the lines; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>Die Pfeiltasten gehen die Linien entlang; Strg+C kopiert das Bild, Strg+E speichert es</translation>
    </message>
    <message>
        <source>What the spectrum says</source>
        <translation>Was das Spektrum sagt</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Whose frequencies; also by dropping a signal of the tree here</source>
        <translation>Wessen Frequenzen; auch, indem ein Signal des Baums hierher gezogen wird</translation>
    </message>
    <message>
        <source>Shown as</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Amplitude or rms value of steady sines; densities of noise, in which the length of the segments does not count</source>
        <translation>Amplitude oder Effektivwert gleichbleibender Sinusse; Dichten von Rauschen, bei denen die Länge der Abschnitte nicht zählt</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektivwert</translation>
    </message>
    <message>
        <source>Power density</source>
        <translation>Leistungsdichte</translation>
    </message>
    <message>
        <source>Amplitude density</source>
        <translation>Amplitudendichte</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Weights against leakage: Hann for most, flat top for exact amplitudes, Blackman-Harris for weak lines beside strong ones</source>
        <translation>Gewichte gegen Leckeffekt: Hann meistens, Flat-Top für genaue Amplituden, Blackman-Harris für schwache Linien neben starken</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letzte</translation>
    </message>
    <message>
        <source>The newest seconds are analysed</source>
        <translation>Die neuesten Sekunden werden analysiert</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Longer segments part lines that are closer, more of them average noise. 0: the whole stretch for amplitudes, at least eight for densities</source>
        <translation>Längere Abschnitte trennen nähere Linien, mehr davon mitteln Rauschen. 0: die ganze Zeit für Amplituden, mindestens acht für Dichten</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Of neighbouring segments</source>
        <translation>Benachbarter Abschnitte</translation>
    </message>
    <message>
        <source>Highest peaks</source>
        <translation>Höchste Spitzen</translation>
    </message>
    <message>
        <source>Lines higher than all others within the window&apos;s main lobe</source>
        <translation>Linien, die höher sind als alle anderen in der Hauptkeule des Fensters</translation>
    </message>
    <message>
        <source>Peak [Hz]</source>
        <translation>Spitze [Hz]</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Value [%1]</source>
        <translation>Wert [%1]</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Über der Zeit</translation>
    </message>
    <message>
        <source>Spectrogram: spectra of the segments beside each other, in colours</source>
        <translation>Spektrogramm: Spektren der Abschnitte nebeneinander, in Farben</translation>
    </message>
    <message>
        <source>The arrow keys walk from the highest value, with Shift ten times as far; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>Die Pfeiltasten gehen vom höchsten Wert aus, mit Umschalt zehnmal so weit; Strg+C kopiert das Bild, Strg+E speichert es</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>The colours&apos; scale in dB, re 1 of the unit</source>
        <translation>Die Skala der Farben in dB, bezogen auf 1 der Einheit</translation>
    </message>
    <message>
        <source>Save the lines as a table (CSV), in SI units</source>
        <translation>Die Linien als Tabelle (CSV) in SI-Einheiten speichern</translation>
    </message>
</context>
<context>
    <name>halbench::app::StopLatch</name>
    <message>
        <source>The stop cannot be released yet.</source>
        <translation>Der Stopp lässt sich noch nicht aufheben.</translation>
    </message>
    <message>
        <source>Wait a moment, look, then release it.</source>
        <translation>Warten Sie einen Moment, sehen Sie nach und heben Sie ihn dann auf.</translation>
    </message>
</context>
<context>
    <name>halbench::app::TopBar</name>
    <message>
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>nothing was armed</source>
        <translation>nichts war freigegeben</translation>
    </message>
    <message>
        <source>connection lost, reconnecting</source>
        <translation>Verbindung verloren, wird gesucht</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Aufheben</translation>
    </message>
    <message>
        <source>Takes the latched stop back and arms nothing; right after a stop it is locked (Space)</source>
        <translation>Hebt den gehaltenen Stopp auf und gibt nichts frei; kurz nach einem Stopp gesperrt (Leertaste)</translation>
    </message>
</context>
<context>
    <name>halbench::app::TriggerBar</name>
    <message>
        <source>State of the trigger</source>
        <translation>Zustand des Triggers</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>Auto shows something after half a second even if nothing happens; Normal waits; Single stops after one event</source>
        <translation>Auto zeigt nach einer halben Sekunde etwas, auch wenn nichts geschieht; Normal wartet; Einzel hält nach einem Ereignis an</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Einzel</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>The signal whose edge is the event, or the set-point</source>
        <translation>Das Signal, dessen Flanke das Ereignis ist, oder der Sollwert</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Flanke</translation>
    </message>
    <message>
        <source>Which way the source passes the level</source>
        <translation>In welcher Richtung die Quelle den Pegel durchläuft</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>steigend</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>either</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>The event is where the source passes it; the line in the plot can be dragged</source>
        <translation>Wo die Quelle ihn durchläuft, ist das Ereignis; die Linie im Diagramm lässt sich ziehen</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>So far on the other side of the level the source must have been before</source>
        <translation>So weit muss die Quelle vorher auf der anderen Seite des Pegels gewesen sein</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>The stretch of time shown of an event</source>
        <translation>Die Zeitspanne, die von einem Ereignis gezeigt wird</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Davor</translation>
    </message>
    <message>
        <source>Share of the window that lies before the event</source>
        <translation>Anteil des Fensters, der vor dem Ereignis liegt</translation>
    </message>
    <message>
        <source>Hold-off</source>
        <translation>Sperrzeit</translation>
    </message>
    <message>
        <source>Least time from one event to the next</source>
        <translation>Kürzeste Zeit von einem Ereignis zum nächsten</translation>
    </message>
    <message>
        <source>Level to the middle</source>
        <translation>Pegel in die Mitte</translation>
    </message>
    <message>
        <source>Sets the level half way between what the source reaches in the view, and the hysteresis to a twentieth of it</source>
        <translation>Setzt den Pegel in die Mitte dessen, was die Quelle im Bild erreicht, und die Hysterese auf ein Zwanzigstel davon</translation>
    </message>
    <message>
        <source>Set-point change</source>
        <translation>Änderung des Sollwerts</translation>
    </message>
    <message>
        <source>the set-point changes</source>
        <translation>sich der Sollwert ändert</translation>
    </message>
    <message>
        <source>%1 rises through %2</source>
        <translation>%1 durch %2 steigt</translation>
    </message>
    <message>
        <source>%1 falls through %2</source>
        <translation>%1 durch %2 fällt</translation>
    </message>
    <message>
        <source>%1 passes %2</source>
        <translation>%1 durch %2 geht</translation>
    </message>
    <message>
        <source>Hysteresis, window and hold-off of the trigger</source>
        <translation>Hysterese, Fenster und Sperrzeit des Triggers</translation>
    </message>
    <message>
        <source>More settings of the trigger</source>
        <translation>Weitere Einstellungen des Triggers</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Reference start</source>
        <translation>Start der Führungsgröße</translation>
    </message>
    <message>
        <source>The board does not have it: it is derived here.</source>
        <translation>Das Steuergerät hat es nicht: Es wird hier abgeleitet.</translation>
    </message>
    <message>
        <source>Live: in the samples that are sent to the plots. Board: the board itself waits, captures up to 4 signals of the plots at the rate of its loop, 4096 rows, and they are read then</source>
        <translation>Live: in den Messwerten, die an die Diagramme gesendet werden. Gerät: Das Steuergerät selbst wartet und nimmt bis zu 4 Signale der Diagramme im Regeltakt auf, 4096 Zeilen, die danach gelesen werden</translation>
    </message>
    <message>
        <source>Live: in the samples that are sent to the plots. %1</source>
        <translation>Live: in den Messwerten, die an die Diagramme gesendet werden. %1</translation>
    </message>
    <message>
        <source>The board waits for its event and shows nothing without one.</source>
        <translation>Das Steuergerät wartet auf sein Ereignis und zeigt ohne eines nichts.</translation>
    </message>
    <message>
        <source>The board looks for one direction only.</source>
        <translation>Das Steuergerät achtet nur auf eine Richtung.</translation>
    </message>
    <message>
        <source>The board has none: every passing of the level is an event.</source>
        <translation>Das Steuergerät hat keine: Jedes Durchlaufen des Pegels ist ein Ereignis.</translation>
    </message>
    <message>
        <source>The board has none: it waits again once its capture is read.</source>
        <translation>Das Steuergerät hat keine: Es wartet erneut, sobald seine Aufnahme gelesen ist.</translation>
    </message>
    <message>
        <source>the reference starts</source>
        <translation>die Führungsgröße startet</translation>
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
        <translation>A&amp;uslegung nach</translation>
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
    <message>
        <source>Largest Ms</source>
        <translation>Größtes Ms</translation>
    </message>
    <message>
        <source>Peak of the sensitivity that is not exceeded: 1.4 is calm, 2 lively. Numbers says whether it is what keeps the error from being less</source>
        <translation>Spitze der Empfindlichkeit, die nicht überschritten wird: 1,4 ist ruhig, 2 lebhaft. Zahlen sagt, ob sie einen kleineren Fehler verhindert</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>the board&apos;s</source>
        <translation>wie Steuergerät</translation>
    </message>
    <message>
        <source>What a step of the height below may ask for; at most what the board gives</source>
        <translation>Was ein Sprung der Höhe darunter verlangen darf; höchstens, was das Steuergerät gibt</translation>
    </message>
    <message>
        <source>In a step of</source>
        <translation>Bei einem Sprung von</translation>
    </message>
    <message>
        <source>The largest step of the reference that shall not reach the current limit</source>
        <translation>Der größte Sprung der Führungsgröße, der die Stromgrenze nicht erreichen soll</translation>
    </message>
    <message>
        <source>Where the loop swings, as the relay experiment measures it; empty: as the model says</source>
        <translation>Wo der Kreis schwingt, wie der Relaisversuch es misst; leer: wie das Modell es sagt</translation>
    </message>
    <message>
        <source>Ultimate gain</source>
        <translation>Kritische Verstärkung</translation>
    </message>
    <message>
        <source>Ultimate period</source>
        <translation>Kritische Periode</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneNumberWords</name>
    <message>
        <source>infinite</source>
        <translation>unendlich</translation>
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
        <source>With friction and current limit</source>
        <translation>Mit Reibung und Stromgrenze</translation>
    </message>
    <message>
        <source>Step of %1</source>
        <translation>Sprung um %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>at rest %1 from the set-point by its own sensors, allowed are %2</source>
        <translation>in Ruhe nach den eigenen Sensoren %1 vom Sollwert entfernt, zulässig sind %2</translation>
    </message>
    <message>
        <source>at rest %1 from the set-point by its own sensors, %2 more than allowed</source>
        <translation>in Ruhe nach den eigenen Sensoren %1 vom Sollwert entfernt, %2 mehr als zulässig</translation>
    </message>
    <message>
        <source>overshoot %1 %, %2 % more than allowed</source>
        <translation>Überschwingen %1 %, %2 % mehr als zulässig</translation>
    </message>
    <message>
        <source>farthest from the prediction, %1, after %2 s</source>
        <translation>am weitesten von der Vorhersage, um %1, nach %2 s</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1: at its bound</source>
        <translation>%1: an der Grenze</translation>
    </message>
    <message>
        <source>At its bound: this is what keeps the error after a load from being less</source>
        <translation>An der Grenze: Dies verhindert einen kleineren Fehler nach einer Last</translation>
    </message>
    <message>
        <source>Peak of sensitivity, Ms</source>
        <translation>Empfindlichkeitsspitze Ms</translation>
    </message>
    <message>
        <source>Current in a step of %1</source>
        <translation>Strom bei einem Sprung von %1</translation>
    </message>
    <message>
        <source>rise %1, %2 overshoot, within 2 % after %3</source>
        <translation>Anstieg %1, %2 Überschwingen, innerhalb 2 % nach %3</translation>
    </message>
    <message>
        <source>Disturbances near the crossover are made so many times larger; at most 2 is usual</source>
        <translation>Störungen nahe der Durchtrittsfrequenz werden um so viel größer; höchstens 2 ist üblich</translation>
    </message>
    <message>
        <source>Noise gain</source>
        <translation>Rauschverstärkung</translation>
    </message>
    <message>
        <source>Current that flickers for each radian of noise in the angle</source>
        <translation>Strom, der je Radiant Rauschen des Winkels flackert</translation>
    </message>
    <message>
        <source>Largest linear step</source>
        <translation>Größter linearer Sprung</translation>
    </message>
    <message>
        <source>A larger one reaches the current limit</source>
        <translation>Ein größerer erreicht die Stromgrenze</translation>
    </message>
    <message>
        <source>One more sample of delay</source>
        <translation>Eine Abtastung mehr Totzeit</translation>
    </message>
    <message>
        <source>stays stable</source>
        <translation>bleibt stabil</translation>
    </message>
    <message>
        <source>Whether the loop bears a current that comes one sample later</source>
        <translation>Ob der Kreis einen Strom verträgt, der eine Abtastung später kommt</translation>
    </message>
    <message>
        <source>%1 at %2 Hz, to %3 %</source>
        <translation>%1 bei %2 Hz, auf %3 %</translation>
    </message>
    <message>
        <source>Integral ends a rest</source>
        <translation>Integrator beendet eine Ruhe</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>nach %1 s</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>From half of the friction band; then the rotor jumps and may rest again: it hunts</source>
        <translation>Von halbem Reibungsband aus; dann springt der Rotor und ruht vielleicht wieder: er ruckelt nach</translation>
    </message>
    <message>
        <source>Limit cycle</source>
        <translation>Dauerschwingung</translation>
    </message>
    <message>
        <source>A swing that friction and the current limit let the loop keep up, by harmonic balance</source>
        <translation>Eine Schwingung, die Reibung und Stromgrenze den Kreis aufrechterhalten lassen, nach der harmonischen Balance</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>not predicted</source>
        <translation>nicht vorhergesagt</translation>
    </message>
    <message>
        <source>The micro-step assist, or a motor without friction, is not in the balance</source>
        <translation>Die Mikroschritthilfe oder ein Motor ohne Reibung ist nicht in der Balance</translation>
    </message>
    <message>
        <source>Swing that grows</source>
        <translation>Schwelle zum Anwachsen</translation>
    </message>
    <message>
        <source>A smaller one comes to rest</source>
        <translation>Eine kleinere kommt zur Ruhe</translation>
    </message>
    <message>
        <source>The rotor will turn by %1, in %2; the board ends it at %3 or %4.</source>
        <translation>Der Rotor dreht um %1, in %2; das Steuergerät beendet es bei %3 oder %4.</translation>
    </message>
    <message>
        <source>After each step the rotor will turn by %1, to and fro, in %2; the board ends it at %3 or %4.</source>
        <translation>Nach jedem Schritt dreht der Rotor um %1, hin und her, in %2; das Steuergerät beendet es bei %3 oder %4.</translation>
    </message>
    <message>
        <source>Peak under a load worth %1 A</source>
        <translation>Spitze unter einer Last von %1 A</translation>
    </message>
    <message>
        <source>How far the load moves the linear loop from its reference</source>
        <translation>Wie weit die Last den linearen Kreis von seiner Führungsgröße entfernt</translation>
    </message>
    <message>
        <source>Recovered from it</source>
        <translation>Davon erholt</translation>
    </message>
    <message>
        <source>not in the time that is shown</source>
        <translation>nicht in der gezeigten Zeit</translation>
    </message>
    <message>
        <source>From then on the angle stays within a tenth of the peak around where it ends</source>
        <translation>Von da an bleibt der Winkel innerhalb eines Zehntels der Spitze um sein Ende</translation>
    </message>
    <message>
        <source>not there after %1</source>
        <translation>nach %1 nicht da</translation>
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
    <message>
        <source>Before the apply</source>
        <translation>Vor dem Übernehmen</translation>
    </message>
    <message>
        <source>5 % to 95 %</source>
        <translation>5 % bis 95 %</translation>
    </message>
    <message>
        <source>Of the motors that the identification&apos;s uncertainty allows; not known without one</source>
        <translation>Der Motoren, die die Unsicherheit der Identifikation zulässt; ohne sie nicht bekannt</translation>
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
        <translation>Übernehmen, prüfen</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
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
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Write the file that the program&apos;s analyse reads</source>
        <translation>Die Datei schreiben, die analyse des Programms liest</translation>
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
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>Choose a method to design anew for the motor as it is now.</source>
        <translation>Wählen Sie ein Verfahren, um sie für den Motor von heute neu zu entwerfen.</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Auslegen</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>Offener Kreis</translation>
    </message>
    <message>
        <source>Step of %1</source>
        <translation>Sprung um %1</translation>
    </message>
    <message>
        <source>A large step with friction and current limit</source>
        <translation>Ein großer Sprung mit Reibung und Stromgrenze</translation>
    </message>
    <message>
        <source>The step of the linear loop</source>
        <translation>Der Sprung des linearen Kreises</translation>
    </message>
    <message>
        <source>Every predicted figure, margins with their interval</source>
        <translation>Alle vorhergesagten Werte, Reserven mit ihrem Intervall</translation>
    </message>
    <message>
        <source>The measured move over its prediction; there is one after Apply and verify</source>
        <translation>Die gemessene Bewegung über ihrer Vorhersage; es gibt sie nach „Übernehmen, prüfen“</translation>
    </message>
    <message>
        <source>Within the predicted band</source>
        <translation>Im vorhergesagten Band</translation>
    </message>
    <message>
        <source>Outside the predicted band</source>
        <translation>Außerhalb des vorhergesagten Bands</translation>
    </message>
    <message>
        <source>The new gains run until the device is switched off.</source>
        <translation>Die neuen Reglerparameter gelten, bis das Gerät ausgeschaltet wird.</translation>
    </message>
    <message>
        <source>To have them after that too: Save in the device, in the Parameters panel.</source>
        <translation>Sollen sie auch danach gelten: „Im Gerät speichern“ im Feld Parameter.</translation>
    </message>
    <message>
        <source>The new gains stay until the device is switched off or, for a simulated one, disconnected; Save in the device, in the Parameters panel, keeps them longer</source>
        <translation>Die neuen Reglerparameter bleiben, bis das Gerät ausgeschaltet oder, wenn es simuliert ist, getrennt wird; „Im Gerät speichern“ im Feld Parameter behält sie länger</translation>
    </message>
    <message>
        <source>The new gains run until the simulated device is disconnected.</source>
        <translation>Die neuen Reglerparameter gelten, bis das simulierte Gerät getrennt wird.</translation>
    </message>
    <message>
        <source>This verification is running</source>
        <translation>Dieser Nachweis läuft</translation>
    </message>
    <message>
        <source>Keep the new gains, or restore those from before.</source>
        <translation>Behalten Sie die neuen Reglerparameter, oder stellen Sie die früheren wieder her.</translation>
    </message>
    <message>
        <source>Nothing verified yet</source>
        <translation>Noch nichts nachgewiesen</translation>
    </message>
    <message>
        <source>Within the predicted band, but these gains do not run any more</source>
        <translation>Im vorhergesagten Band, aber diese Reglerparameter laufen nicht mehr</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>Entwürfe</translation>
    </message>
    <message>
        <source>Designs kept under a name, beside the proposed one</source>
        <translation>Unter einem Namen behaltene Entwürfe neben dem vorgeschlagenen</translation>
    </message>
    <message>
        <source>Bode, Nyquist and Nichols plot, and sensitivity</source>
        <translation>Bode-, Nyquist- und Nichols-Diagramm sowie Empfindlichkeit</translation>
    </message>
    <message>
        <source>Open a measured response</source>
        <translation>Gemessenen Frequenzgang öffnen</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>Frequenzgang (*.json)</translation>
    </message>
    <message>
        <source>The measured response is drawn into the open loop, with the proposed gains.</source>
        <translation>Der gemessene Frequenzgang ist in den offenen Kreis eingezeichnet, mit den vorgeschlagenen Reglerparametern.</translation>
    </message>
    <message>
        <source>%1 of its %2 frequencies are coherent; the others are hollow.</source>
        <translation>%1 seiner %2 Frequenzen sind kohärent; die anderen sind hohl.</translation>
    </message>
    <message>
        <source>Measured response…</source>
        <translation>Messung …</translation>
    </message>
    <message>
        <source>The open loop shows predictions alone again</source>
        <translation>Der offene Kreis zeigt wieder nur Vorhersagen</translation>
    </message>
    <message>
        <source>Draw what identify --frequency measured into the open loop, with the gains proposed here: no model of the motor is in it</source>
        <translation>Zeichnet in den offenen Kreis, was identify --frequency gemessen hat, mit den hier vorgeschlagenen Reglerparametern: Kein Modell des Motors steckt darin</translation>
    </message>
    <message>
        <source>Gains (*.json);;The law as C (*.c)</source>
        <translation>Reglerparameter (*.json);;Das Regelgesetz als C (*.c)</translation>
    </message>
    <message>
        <source>kept on %1</source>
        <translation>behalten auf %1</translation>
    </message>
    <message>
        <source>This project has them as the design &apos;%1&apos;, to be applied again after that.</source>
        <translation>Dieses Projekt hat sie als Entwurf „%1“; danach lassen sie sich wieder übernehmen.</translation>
    </message>
    <message>
        <source>This project has them as the design &apos;%1&apos;.</source>
        <translation>Dieses Projekt hat sie als Entwurf „%1“.</translation>
    </message>
    <message>
        <source>applied on %1</source>
        <translation>angewendet auf %1</translation>
    </message>
    <message>
        <source>The gains that were applied on %1 were neither kept nor restored.</source>
        <translation>Die auf %1 übernommenen Reglerparameter wurden weder behalten noch zurückgenommen.</translation>
    </message>
    <message>
        <source>The gains that were kept on %1 were left with it.</source>
        <translation>Die auf %1 behaltenen Reglerparameter blieben bei ihm.</translation>
    </message>
    <message>
        <source>A simulated device is new whenever it is connected and has them no more.</source>
        <translation>Ein simuliertes Gerät ist bei jedem Verbinden neu und hat sie nicht mehr.</translation>
    </message>
    <message>
        <source>It has them until it is switched off.</source>
        <translation>Es hat sie, bis es ausgeschaltet wird.</translation>
    </message>
    <message>
        <source>This project has them as the design &apos;%1&apos;: Take up, then Apply and verify, runs them again.</source>
        <translation>Dieses Projekt hat sie als Entwurf „%1“: „Übernehmen“ bei den Entwürfen, dann „Übernehmen, prüfen“ lässt sie wieder laufen.</translation>
    </message>
    <message>
        <source>not judged: the project&apos;s entry cannot be read</source>
        <translation>nicht beurteilt: der Eintrag des Projekts ist nicht lesbar</translation>
    </message>
    <message>
        <source>not judged yet</source>
        <translation>noch nicht beurteilt</translation>
    </message>
    <message>
        <source>not judged: %1</source>
        <translation>nicht beurteilt: %1</translation>
    </message>
    <message>
        <source>All gains at once, then a step that must go as predicted; Esc stops it</source>
        <translation>Alle Reglerparameter auf einmal, dann ein Sprung, der wie vorhergesagt gehen muss; Esc stoppt ihn</translation>
    </message>
    <message>
        <source>Take up %1</source>
        <translation>%1 übernehmen</translation>
    </message>
    <message>
        <source>Gains by %1</source>
        <translation>Auslegung nach %1</translation>
    </message>
    <message>
        <source>Edit the gains</source>
        <translation>Reglerparameter bearbeiten</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>%1 bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Move a pole</source>
        <translation>Pol verschieben</translation>
    </message>
    <message>
        <source>Move the crossover</source>
        <translation>Durchtrittsfrequenz verschieben</translation>
    </message>
    <message>
        <source>Move the phase margin</source>
        <translation>Phasenreserve verschieben</translation>
    </message>
    <message>
        <source>Gains from the project: %1.</source>
        <translation>Reglerparameter aus dem Projekt: %1.</translation>
    </message>
    <message>
        <source>Within the predicted band: the gains that were applied, not those shown now</source>
        <translation>Im vorhergesagten Band: die übernommenen Reglerparameter, nicht die jetzt gezeigten</translation>
    </message>
    <message>
        <source>In small steps</source>
        <translation>In kleinen Schritten</translation>
    </message>
    <message>
        <source>From the gains that run to the new ones in steps that change K_P and K_P + K_D/T by half at most, each judged before it is written and proved by a move; if one leaves its band, the gains from before run again</source>
        <translation>Von den laufenden Reglerparametern zu den neuen in Schritten, die K_P und K_P + K_D/T um höchstens die Hälfte ändern, jeder vor dem Schreiben beurteilt und durch eine Bewegung nachgewiesen; verlässt eine ihr Band, laufen die von vorher wieder</translation>
    </message>
    <message>
        <source>Outside the predicted band: the gains that were applied, not those shown now</source>
        <translation>Außerhalb des vorhergesagten Bandes: die übernommenen Reglerparameter, nicht die jetzt gezeigten</translation>
    </message>
    <message>
        <source>Motor (SI, 95 %): %1</source>
        <translation>Motor (SI, 95 %): %1</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Was wäre wenn</translation>
    </message>
    <message>
        <source>A recorded move, and what the proposed gains would have made of it</source>
        <translation>Eine aufgezeichnete Bewegung, und was die vorgeschlagenen Reglerparameter daraus gemacht hätten</translation>
    </message>
    <message>
        <source>Counted from where the rotor is when it starts</source>
        <translation>Gezählt von dort, wo der Rotor beim Start steht</translation>
    </message>
    <message>
        <source>Remove the response</source>
        <translation>Messung entfernen</translation>
    </message>
    <message>
        <source>More gain would be unstable: it stays below.</source>
        <translation>Mehr Verstärkung wäre instabil: bleibt darunter.</translation>
    </message>
    <message>
        <source>Open a recorded move</source>
        <translation>Aufgezeichnete Bewegung öffnen</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4)</source>
        <translation>Aufzeichnung (*.csv *.mf4)</translation>
    </message>
    <message>
        <source>Open the gains that ran</source>
        <translation>Reglerparameter öffnen, die liefen</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>Reglerparameter (*.json)</translation>
    </message>
    <message>
        <source>The recording is shown once there is an identified motor.</source>
        <translation>Die Aufzeichnung wird gezeigt, sobald es einen identifizierten Motor gibt.</translation>
    </message>
    <message>
        <source>What if: %1</source>
        <translation>Was wäre wenn: %1</translation>
    </message>
    <message>
        <source>Choose the file of the gains that ran then.</source>
        <translation>Wählen Sie die Datei der Reglerparameter, die damals liefen.</translation>
    </message>
    <message>
        <source>Gains that ran…</source>
        <translation>Damalige Reglerparameter …</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>What a load that appears at once does to the angle</source>
        <translation>Was eine Last, die plötzlich auftritt, mit dem Winkel macht</translation>
    </message>
    <message>
        <source>Open gains</source>
        <translation>Reglerparameter öffnen</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Gains of %1.</source>
        <translation>Reglerparameter aus %1.</translation>
    </message>
    <message>
        <source>Open gains…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Gains of a file become the proposed ones; they are judged for this motor before they can be applied</source>
        <translation>Die Reglerparameter einer Datei werden die vorgeschlagenen; sie werden für diesen Motor beurteilt, bevor sie angewendet werden können</translation>
    </message>
    <message>
        <source>These gains cannot be applied: %1. %2.</source>
        <translation>Diese Reglerparameter können nicht übernommen werden: %1; %2.</translation>
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
        <source>friction band</source>
        <translation>Reibungsband</translation>
    </message>
    <message>
        <source>Predicted step with friction and current limit,</source>
        <translation>Vorhergesagter Sprung mit Reibung und Stromgrenze,</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorhergesagt</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Verification move</source>
        <translation>Prüfbewegung</translation>
    </message>
    <message>
        <source>Predicted step of %1, linear loop</source>
        <translation>Vorhergesagter Sprung um %1, linearer Kreis</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>allowed %1</source>
        <translation>zulässig %1</translation>
    </message>
    <message>
        <source>friction band %1</source>
        <translation>Reibungsband %1</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>measured, not coherent</source>
        <translation>gemessen, nicht kohärent</translation>
    </message>
    <message>
        <source>5 % to 95 % of the motors</source>
        <translation>5 % bis 95 % der Motoren</translation>
    </message>
    <message>
        <source>with the proposed gains</source>
        <translation>mit den vorgeschlagenen Reglerparametern</translation>
    </message>
    <message>
        <source>nine tenths of such moves</source>
        <translation>neun Zehntel solcher Bewegungen</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>Recorded move</source>
        <translation>Aufgezeichnete Bewegung</translation>
    </message>
    <message>
        <source>Load worth %1 A, linear loop</source>
        <translation>Last im Wert von %1 A, linearer Kreis</translation>
    </message>
    <message>
        <source>angle from the reference</source>
        <translation>Winkel gegen die Führungsgröße</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>recovered after</source>
        <translation>erholt nach</translation>
    </message>
    <message>
        <source>other crossings</source>
        <translation>andere Durchtritte</translation>
    </message>
    <message>
        <source>circled %1 times; unstable poles of L: %2</source>
        <translation>umlaufen: %1 Mal; instabile Pole von L: %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::UnkeptBar</name>
    <message>
        <source>The project stays open, because what is not saved could not be kept: %1</source>
        <translation>Das Projekt bleibt geöffnet, weil nicht Gespeichertes nicht gesichert werden konnte: %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Writes it once more and goes on</source>
        <translation>Schreibt noch einmal und fährt fort</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>Projekt speichern unter …</translation>
    </message>
    <message>
        <source>Saves it elsewhere and goes on</source>
        <translation>Speichert es anderswo und fährt fort</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Goes on; what was not saved is lost</source>
        <translation>Fährt fort; nicht Gespeichertes geht verloren</translation>
    </message>
</context>
<context>
    <name>halbench::app::WhatIfPage</name>
    <message>
        <source>No recording is chosen</source>
        <translation>Keine Aufzeichnung gewählt</translation>
    </message>
    <message>
        <source>A recorded move is shown with what the proposed gains would have made of it, if the identified motor explains it.</source>
        <translation>Eine aufgezeichnete Bewegung wird mit dem gezeigt, was die vorgeschlagenen Reglerparameter daraus gemacht hätten, wenn der identifizierte Motor sie erklärt.</translation>
    </message>
    <message>
        <source>Open a recorded move</source>
        <translation>Aufgezeichnete Bewegung öffnen</translation>
    </message>
    <message>
        <source>Another move…</source>
        <translation>Andere Bewegung …</translation>
    </message>
    <message>
        <source>Choose another recording</source>
        <translation>Eine andere Aufzeichnung wählen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>This page is empty again; the recording stays</source>
        <translation>Diese Seite ist wieder leer; die Aufzeichnung bleibt</translation>
    </message>
    <message>
        <source>%1: withheld, what the proposed gains would make of it</source>
        <translation>%1: Was die vorgeschlagenen Reglerparameter daraus machen würden, wird nicht gesagt</translation>
    </message>
    <message>
        <source>%1 is being judged</source>
        <translation>%1 wird beurteilt</translation>
    </message>
    <message>
        <source>%1 waits for an identified motor</source>
        <translation>%1 wartet auf einen identifizierten Motor</translation>
    </message>
    <message>
        <source>%1: the identified loop explains the recorded move</source>
        <translation>%1: Der identifizierte Kreis erklärt die aufgezeichnete Bewegung</translation>
    </message>
    <message>
        <source>%1: doubtful, as said below</source>
        <translation>%1: zweifelhaft, wie unten gesagt</translation>
    </message>
    <message>
        <source>%1 % of the recorded motion lie outside the band of the gains that ran.</source>
        <translation>%1 % der aufgezeichneten Bewegung liegen außerhalb des Bandes der Reglerparameter, die liefen.</translation>
    </message>
    <message>
        <source>The proposed gains are those that ran: the recording is what they make of it.</source>
        <translation>Die vorgeschlagenen Reglerparameter sind die, die liefen: Die Aufzeichnung ist, was sie daraus machen.</translation>
    </message>
</context>
<context>
    <name>halbench::app::WhatIfWords</name>
    <message>
        <source>What the proposed gains would make of this move is not said: %1</source>
        <translation>Was die vorgeschlagenen Reglerparameter aus dieser Bewegung machen würden, wird nicht gesagt: %1</translation>
    </message>
    <message>
        <source>With the proposed gains this move would overshoot by %1 instead of %2 and end %3 from its set-point instead of %4.</source>
        <translation>Mit den vorgeschlagenen Reglerparametern würde diese Bewegung um %1 statt %2 überschwingen und %3 statt %4 neben ihrem Sollwert enden.</translation>
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
    <name>halbench::app::XyPanel</name>
    <message>
        <source>Nothing to show yet</source>
        <translation>Noch nichts zu zeigen</translation>
    </message>
    <message>
        <source>Shows two signals of a connected device against each other, at first the Hall sensors with their ellipse. Choose a device at the left, or try the simulated motor.</source>
        <translation>Zeigt zwei Signale eines verbundenen Geräts gegeneinander, zuerst die Hall-Sensoren mit ihrer Ellipse. Wählen Sie links ein Gerät oder probieren Sie den simulierten Motor.</translation>
    </message>
    <message>
        <source>The arrow keys walk along the points; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>Die Pfeiltasten gehen die Punkte entlang; Strg+C kopiert das Bild, Strg+E speichert es</translation>
    </message>
    <message>
        <source>What the ellipse says</source>
        <translation>Was die Ellipse sagt</translation>
    </message>
    <message>
        <source>Fitted ellipse</source>
        <translation>Angepasste Ellipse</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Waagerecht</translation>
    </message>
    <message>
        <source>The signal of the horizontal axis; also by dropping one of the tree here</source>
        <translation>Das Signal der waagerechten Achse; auch, indem eines des Baums hierher gezogen wird</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>The signal of the vertical axis; also by dropping one of the tree here</source>
        <translation>Das Signal der senkrechten Achse; auch, indem eines des Baums hierher gezogen wird</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letzte</translation>
    </message>
    <message>
        <source>The newest seconds are shown</source>
        <translation>Die neuesten Sekunden werden gezeigt</translation>
    </message>
    <message>
        <source>Ellip&amp;se</source>
        <translation>Ellip&amp;se</translation>
    </message>
    <message>
        <source>Fits an ellipse through the points; they must go round it several times (Alt+E)</source>
        <translation>Passt eine Ellipse an die Punkte an; sie müssen mehrmals herumgehen (Alt+E)</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 über %2</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Centre of %1</source>
        <translation>Mitte von %1</translation>
    </message>
    <message>
        <source>Amplitude of %1</source>
        <translation>Amplitude von %1</translation>
    </message>
    <message>
        <source>Ratio of the amplitudes</source>
        <translation>Verhältnis der Amplituden</translation>
    </message>
    <message>
        <source>Phase beyond 90°</source>
        <translation>Phase über 90°</translation>
    </message>
    <message>
        <source>Longest and shortest radius %1 and %2 %3</source>
        <translation>Längster und kürzester Radius %1 und %2 %3</translation>
    </message>
    <message>
        <source>rms distance of the points from the ellipse %1 % of the amplitude</source>
        <translation>Effektiver Abstand der Punkte von der Ellipse %1 % der Amplitude</translation>
    </message>
    <message>
        <source>Save all points as a table (CSV), in SI units</source>
        <translation>Alle Punkte als Tabelle (CSV) in SI-Einheiten speichern</translation>
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
    <message>
        <source>Cursor pair</source>
        <translation>Messmarkenpaar</translation>
    </message>
    <message>
        <source>Pair that measures</source>
        <translation>Paar, das misst</translation>
    </message>
    <message>
        <source>Name of the cursor pair</source>
        <translation>Name des Messmarkenpaars</translation>
    </message>
    <message>
        <source>Name of the pair that measures; a pair with a name is kept in the project (F2)</source>
        <translation>Name des Paars, das misst; ein Paar mit Namen bleibt im Projekt (F2)</translation>
    </message>
    <message>
        <source>Pair that measures: %1. N adds one, P chooses the next, F2 names it; the others are drawn faint</source>
        <translation>Paar, das misst: %1. N fügt eines hinzu, P wählt das nächste, F2 benennt es; die anderen sind schwach gezeichnet</translation>
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
    <message>
        <source>Drag: %1</source>
        <translation>Ziehen: %1</translation>
    </message>
    <message>
        <source>Ctrl and the arrow keys move: %1.</source>
        <translation>Strg und die Pfeiltasten verschieben: %1.</translation>
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
    <message>
        <source>%1 (right)</source>
        <translation>%1 (rechts)</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LiveLegend</name>
    <message>
        <source>Legend with live values</source>
        <translation>Legende mit laufenden Werten</translation>
    </message>
    <message>
        <source>The chosen curve</source>
        <translation>Die gewählte Kurve</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>To the left axis</source>
        <translation>Auf die linke Achse</translation>
    </message>
    <message>
        <source>To the right axis</source>
        <translation>Auf die rechte Achse</translation>
    </message>
    <message>
        <source>To the plot above</source>
        <translation>Ins Diagramm darüber</translation>
    </message>
    <message>
        <source>To the plot below</source>
        <translation>Ins Diagramm darunter</translation>
    </message>
    <message>
        <source>Remove from the plot</source>
        <translation>Aus dem Diagramm entfernen</translation>
    </message>
    <message>
        <source>Into a plot of its own</source>
        <translation>In ein eigenes Diagramm</translation>
    </message>
    <message>
        <source>To the plot at the left</source>
        <translation>Ins Diagramm links</translation>
    </message>
    <message>
        <source>To the plot at the right</source>
        <translation>Ins Diagramm rechts</translation>
    </message>
    <message>
        <source>Into a plot of its own at the right</source>
        <translation>In ein eigenes Diagramm rechts</translation>
    </message>
    <message>
        <source>Space hides or shows the chosen curve, R puts it on the other axis, U offers its units, Ctrl and an arrow key puts it into the plot on that side, Ctrl+Shift+Down into one of its own, Ctrl+Shift+Right into one beside, Delete removes it from the plot.</source>
        <translation>Die Leertaste blendet die gewählte Kurve aus oder ein, R legt sie auf die andere Achse, U bietet ihre Einheiten an, Strg und eine Pfeiltaste legt sie ins Diagramm auf dieser Seite, Strg+Umschalt+Herunter in ein eigenes, Strg+Umschalt+Rechts in ein eigenes daneben, Entf nimmt sie aus dem Diagramm.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
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
        <source>Plot of %1, at the right %2</source>
        <translation>Diagramm: %1, rechts %2</translation>
    </message>
    <message>
        <source>Arrow keys move a cursor or scroll, plus and minus zoom the time, with Ctrl the values, Space pauses, F fits, Insert adds signals.</source>
        <translation>Die Pfeiltasten bewegen eine Messmarke oder verschieben, Plus und Minus zoomen die Zeit, mit Strg die Werte, die Leertaste hält an, F passt ein, Einfg fügt Signale hinzu.</translation>
    </message>
    <message>
        <source>%1, column %2</source>
        <translation>%1, Spalte %2</translation>
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
        <source>Following, %1 s</source>
        <translation>Folgt, %1 s</translation>
    </message>
    <message>
        <source>Scrolled; press End to follow</source>
        <translation>Verschoben; Ende drücken, um zu folgen</translation>
    </message>
    <message>
        <source>Triggered view; press End to follow</source>
        <translation>Ansicht des Triggers; Ende folgt wieder</translation>
    </message>
    <message>
        <source>Keep as reference</source>
        <translation>Als Referenz behalten</translation>
    </message>
    <message>
        <source>What is shown stays as faint curves below the live ones</source>
        <translation>Was gezeigt wird, bleibt als blasse Kurven unter den laufenden</translation>
    </message>
    <message>
        <source>Remove the reference</source>
        <translation>Referenz entfernen</translation>
    </message>
    <message>
        <source>The faint curves go</source>
        <translation>Die blassen Kurven verschwinden</translation>
    </message>
    <message>
        <source>what was shown</source>
        <translation>was gezeigt wurde</translation>
    </message>
    <message>
        <source>Remove the reference: %1</source>
        <translation>Referenz entfernen: %1</translation>
    </message>
    <message>
        <source>New cursor pair</source>
        <translation>Neues Messmarkenpaar</translation>
    </message>
    <message>
        <source>Two more cursors, in view; the pairs before stay where they are, faint</source>
        <translation>Zwei weitere Messmarken im Bild; die Paare davor bleiben, wo sie sind, schwach gezeichnet</translation>
    </message>
    <message>
        <source>Remove the cursor pair</source>
        <translation>Messmarkenpaar entfernen</translation>
    </message>
    <message>
        <source>The pair that measures goes</source>
        <translation>Das Paar, das misst, verschwindet</translation>
    </message>
    <message>
        <source>Next cursor pair</source>
        <translation>Nächstes Messmarkenpaar</translation>
    </message>
    <message>
        <source>The next pair measures</source>
        <translation>Das nächste Paar misst</translation>
    </message>
    <message>
        <source>Previous cursor pair</source>
        <translation>Voriges Messmarkenpaar</translation>
    </message>
    <message>
        <source>The pair before measures</source>
        <translation>Das vorige Paar misst</translation>
    </message>
    <message>
        <source>Name the cursor pair</source>
        <translation>Messmarkenpaar benennen</translation>
    </message>
    <message>
        <source>A name for the pair that measures; the project keeps it</source>
        <translation>Ein Name für das Paar, das misst; das Projekt behält ihn</translation>
    </message>
    <message>
        <source>Go to the cursor pair</source>
        <translation>Zum Messmarkenpaar gehen</translation>
    </message>
    <message>
        <source>Show the stretch of time around the pair that measures</source>
        <translation>Die Zeitspanne um das Paar zeigen, das misst</translation>
    </message>
    <message>
        <source>Bring the cursor pair here</source>
        <translation>Messmarkenpaar hierher holen</translation>
    </message>
    <message>
        <source>The pair that measures comes into view</source>
        <translation>Das Paar, das misst, kommt ins Bild</translation>
    </message>
    <message>
        <source>A pair needs a name; it is still called %1</source>
        <translation>Ein Paar braucht einen Namen; es heißt weiter %1</translation>
    </message>
    <message>
        <source>There is a pair %1 already; this one is still called %2</source>
        <translation>Ein Paar %1 gibt es schon; dieses heißt weiter %2</translation>
    </message>
    <message>
        <source>Own time axis, paused</source>
        <translation>Eigene Zeitachse, angehalten</translation>
    </message>
    <message>
        <source>Own time axis, following, %1 s</source>
        <translation>Eigene Zeitachse, folgt, %1 s</translation>
    </message>
    <message>
        <source>Own time axis, scrolled; press End to follow</source>
        <translation>Eigene Zeitachse, verschoben; Ende folgt wieder</translation>
    </message>
    <message>
        <source>Time axis of %1</source>
        <translation>Zeitachse von %1</translation>
    </message>
    <message>
        <source>Own time axis</source>
        <translation>Eigene Zeitachse</translation>
    </message>
    <message>
        <source>The plot zooms and scrolls by itself, with its own time below it; again: with the others</source>
        <translation>Das Diagramm zoomt und scrollt für sich, mit eigener Zeit darunter; noch einmal: mit den anderen</translation>
    </message>
    <message>
        <source>One time axis for all plots</source>
        <translation>Eine Zeitachse für alle Diagramme</translation>
    </message>
    <message>
        <source>Plots with their own time axis share the others&apos; again</source>
        <translation>Diagramme mit eigener Zeitachse teilen wieder die der anderen</translation>
    </message>
    <message>
        <source>Time axis of column %1</source>
        <translation>Zeitachse der Spalte %1</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>Zeitachse</translation>
    </message>
    <message>
        <source>Plot to the right</source>
        <translation>Diagramm nach rechts</translation>
    </message>
    <message>
        <source>The plot goes into the column at the right; beyond the last one into a new column</source>
        <translation>Das Diagramm geht in die Spalte rechts, jenseits der letzten in eine neue</translation>
    </message>
    <message>
        <source>Plot to the left</source>
        <translation>Diagramm nach links</translation>
    </message>
    <message>
        <source>The plot goes into the column at the left; beyond the first one into a new column</source>
        <translation>Das Diagramm geht in die Spalte links, jenseits der ersten in eine neue</translation>
    </message>
    <message>
        <source>New plot at the right</source>
        <translation>Neues Diagramm rechts</translation>
    </message>
    <message>
        <source>An empty plot in a column of its own</source>
        <translation>Ein leeres Diagramm in einer eigenen Spalte</translation>
    </message>
    <message>
        <source>Remove the plot</source>
        <translation>Diagramm entfernen</translation>
    </message>
    <message>
        <source>The plot goes with its curves; a column goes with its last plot</source>
        <translation>Das Diagramm geht mit seinen Kurven, eine Spalte mit ihrem letzten Diagramm</translation>
    </message>
    <message>
        <source>Marker with a note</source>
        <translation>Marke mit Notiz</translation>
    </message>
    <message>
        <source>Type the note of the chosen marker, of the one at this moment, or of a new one</source>
        <translation>Die Notiz der gewählten Marke schreiben, der in diesem Augenblick oder einer neuen</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>Nächste Marke</translation>
    </message>
    <message>
        <source>Choose the next marker and bring it into view</source>
        <translation>Die nächste Marke wählen und ins Bild bringen</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>Vorige Marke</translation>
    </message>
    <message>
        <source>Choose the marker before and bring it into view</source>
        <translation>Die vorige Marke wählen und ins Bild bringen</translation>
    </message>
    <message>
        <source>Remove the marker</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>The chosen marker goes</source>
        <translation>Die gewählte Marke geht</translation>
    </message>
    <message>
        <source>List of markers</source>
        <translation>Liste der Marken</translation>
    </message>
    <message>
        <source>All markers with their notes; choose one</source>
        <translation>Alle Marken mit ihren Notizen; eine wählen</translation>
    </message>
    <message>
        <source>Zoom the values in</source>
        <translation>Werte vergrößern</translation>
    </message>
    <message>
        <source>Show fewer values of the plot with the focus, around the middle</source>
        <translation>Weniger Werte des Diagramms mit dem Fokus zeigen, um die Mitte</translation>
    </message>
    <message>
        <source>Zoom the values out</source>
        <translation>Werte verkleinern</translation>
    </message>
    <message>
        <source>Show more values of the plot with the focus</source>
        <translation>Mehr Werte des Diagramms mit dem Fokus zeigen</translation>
    </message>
    <message>
        <source>Fit the values</source>
        <translation>Werte einpassen</translation>
    </message>
    <message>
        <source>The value axes of the plot with the focus follow its data again</source>
        <translation>Die Wertachsen des Diagramms mit dem Fokus folgen wieder seinen Daten</translation>
    </message>
    <message>
        <source>Taller plot</source>
        <translation>Diagramm höher</translation>
    </message>
    <message>
        <source>The plot gets taller, the others of its column shorter</source>
        <translation>Das Diagramm wird höher, die anderen seiner Spalte niedriger</translation>
    </message>
    <message>
        <source>Shorter plot</source>
        <translation>Diagramm niedriger</translation>
    </message>
    <message>
        <source>The plot gets shorter, the others of its column taller</source>
        <translation>Das Diagramm wird niedriger, die anderen seiner Spalte höher</translation>
    </message>
    <message>
        <source>Wider column</source>
        <translation>Spalte breiter</translation>
    </message>
    <message>
        <source>The column of the plot gets wider, the others narrower</source>
        <translation>Die Spalte des Diagramms wird breiter, die anderen schmaler</translation>
    </message>
    <message>
        <source>Narrower column</source>
        <translation>Spalte schmaler</translation>
    </message>
    <message>
        <source>The column of the plot gets narrower, the others wider</source>
        <translation>Die Spalte des Diagramms wird schmaler, die anderen breiter</translation>
    </message>
    <message>
        <source>Equal sizes</source>
        <translation>Gleiche Größen</translation>
    </message>
    <message>
        <source>All columns equally wide, all plots of a column equally tall</source>
        <translation>Alle Spalten gleich breit, alle Diagramme einer Spalte gleich hoch</translation>
    </message>
    <message>
        <source>Paused, %1 s kept</source>
        <translation>Angehalten, seither %1 s</translation>
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
    <message>
        <source>Time of day where this window runs</source>
        <translation>Uhrzeit dort, wo dieses Fenster läuft</translation>
    </message>
    <message>
        <source>Time on the device&apos;s own clock, as in its recordings</source>
        <translation>Zeit auf der eigenen Uhr des Geräts, wie in seinen Aufnahmen</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhrzeit</translation>
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
    <name>halbench::widgets::MarkerBar</name>
    <message>
        <source>List of markers</source>
        <translation>Liste der Marken</translation>
    </message>
    <message>
        <source>Time of the chosen marker</source>
        <translation>Zeit der gewählten Marke</translation>
    </message>
    <message>
        <source>Note of the chosen marker</source>
        <translation>Notiz der gewählten Marke</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>What is written at the marker; Enter keeps it, Esc leaves it as it was</source>
        <translation>Was an der Marke steht; die Eingabetaste behält es, Esc lässt es, wie es war</translation>
    </message>
    <message>
        <source>Close the marker&apos;s row</source>
        <translation>Zeile der Marke schließen</translation>
    </message>
    <message>
        <source>Nothing is chosen any more; the marker stays</source>
        <translation>Keine ist mehr gewählt; die Marke bleibt</translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n Marke</numerusform>
            <numerusform>%n Marken</numerusform>
        </translation>
    </message>
    <message>
        <source>All markers by time (Ctrl+J); J chooses the next one</source>
        <translation>Alle Marken nach der Zeit (Strg+J); J wählt die nächste</translation>
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
    <name>halbench::widgets::NumberWords</name>
    <message>
        <source>&apos;%1&apos; belongs to no number; taken are digits, a sign, &apos;%2&apos; before the decimals and e before a power of ten.</source>
        <translation>„%1“ gehört zu keiner Zahl; möglich sind Ziffern, ein Vorzeichen, „%2“ vor den Nachkommastellen und e vor einer Zehnerpotenz.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; could be misread here: write &apos;%2&apos; before the decimals and nothing between thousands.</source>
        <translation>„%1“ ist hier missverständlich: Schreiben Sie „%2“ vor die Nachkommastellen und nichts zwischen Tausender.</translation>
    </message>
    <message>
        <source>This is not a number.</source>
        <translation>Das ist keine Zahl.</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::OptionalNumberEdit</name>
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
    <message>
        <source>Allowed: %1.</source>
        <translation>Erlaubt: %1.</translation>
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
        <source>old values</source>
        <translation>alte Werte</translation>
    </message>
    <message>
        <source>Angle ψ %1</source>
        <translation>Winkel ψ %1</translation>
    </message>
    <message>
        <source>Coil A
%1
Coil B
%2</source>
        <translation>Spule A
%1
Spule B
%2</translation>
    </message>
    <message>
        <source>Hall A
%1
Hall B
%2</source>
        <translation>Hall A
%1
Hall B
%2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ShareSplitter</name>
    <message>
        <source>Drag to share the room; a double click shares it evenly</source>
        <translation>Ziehen teilt den Platz, ein Doppelklick teilt ihn gleichmäßig</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::SpectrogramView</name>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Spectrogram</source>
        <translation>Spektrogramm</translation>
    </message>
    <message>
        <source>Nothing to show yet</source>
        <translation>Noch nichts zu zeigen</translation>
    </message>
    <message>
        <source>highest %1</source>
        <translation>höchster Wert %1</translation>
    </message>
    <message>
        <source>%1 s, %2 Hz: %3 %4</source>
        <translation>%1 s, %2 Hz: %3 %4</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StaleWords</name>
    <message>
        <source>No new value since %1 s on the time axis</source>
        <translation>Kein neuer Wert seit %1 s auf der Zeitachse</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StatisticsTable</name>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektivwert</translation>
    </message>
    <message>
        <source>Std dev</source>
        <translation>Std.-Abw.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Copy the table</source>
        <translation>Tabelle kopieren</translation>
    </message>
    <message>
        <source>Pk-pk</source>
        <translation>Sp.-Sp.</translation>
    </message>
    <message>
        <source>Peak to peak: largest less smallest value</source>
        <translation>Spitze-Spitze: größter minus kleinster Wert</translation>
    </message>
    <message>
        <source>Slope/s</source>
        <translation>Steigung/s</translation>
    </message>
    <message>
        <source>From cursor A to B: of the signal&apos;s unit per second</source>
        <translation>Von Messmarke A bis B: in der Einheit des Signals je Sekunde</translation>
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
        <source>Armed, %1</source>
        <translation>Freigegeben, %1</translation>
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
        <source>STOP</source>
        <translation>STOPP</translation>
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
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Software stop: current to zero at once, latched until it is released (Esc)</source>
        <translation>Software-Stopp: Strom sofort auf null, gehalten, bis er aufgehoben wird (Esc)</translation>
    </message>
    <message>
        <source>Stopped, stop again</source>
        <translation>Gestoppt, erneut stoppen</translation>
    </message>
    <message>
        <source>%1 This and Esc still stop; Release, beside the state, takes the stop back.</source>
        <translation>%1 Diese Taste und Esc stoppen weiterhin; „Aufheben“ neben dem Zustand nimmt den Stopp zurück.</translation>
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
    <message>
        <source>time from the event [s]</source>
        <translation>Zeit ab dem Ereignis [s]</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::UnitMenu</name>
    <message>
        <source>As in the preferences (%1)</source>
        <translation>Wie in den Einstellungen (%1)</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Einheit von %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::VerdictView</name>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::WindowTerms</name>
    <message>
        <source>choose Identify again and enter the given inertia J or the given torque constant φ</source>
        <translation>„Neu identifizieren“ wählen und die bekannte Trägheit J oder die bekannte Drehmomentkonstante φ eintragen</translation>
    </message>
    <message>
        <source>identify the bare motor again and leave the given constants empty</source>
        <translation>den Motor ohne Zusatz erneut identifizieren und die bekannten Größen leer lassen</translation>
    </message>
    <message>
        <source>steady speeds alone do not show the inertia: identify again with run-ups and coast-downs, or enter the given inertia J</source>
        <translation>konstante Drehzahlen allein zeigen die Trägheit nicht: mit Hochlauf und Auslauf erneut identifizieren oder die bekannte Trägheit J eintragen</translation>
    </message>
    <message>
        <source>enter the bandwidth that is wanted</source>
        <translation>die gewünschte Bandbreite eintragen</translation>
    </message>
    <message>
        <source>enter the phase margin that is wanted</source>
        <translation>die gewünschte Phasenreserve eintragen</translation>
    </message>
</context>
</TS>
