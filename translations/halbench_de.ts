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
    <message>
        <source>Estimators</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation>Winkelfehler</translation>
    </message>
</context>
<context>
    <name>Phrases</name>
    <message>
        <source> And {}. {}</source>
        <translation> Und {}. {}</translation>
    </message>
    <message>
        <source>When it stood in another cell, disarm it, bring it to the middle of its travel, set hb.home to 1 and start again.</source>
        <translation>Stand es in einer anderen Zelle, so sperren Sie es, bringen Sie es in die Mitte des Verfahrwegs, setzen Sie hb.home auf 1 und starten Sie neu.</translation>
    </message>
    <message>
        <source>the device was not homed: where it stood was taken for its first cell, from which positions and the ends of travel count</source>
        <translation>das Gerät war nicht referenziert: wo es stand, gilt als seine erste Zelle, von der aus Lagen und Enden des Verfahrwegs zählen</translation>
    </message>
    <message>
        <source>Check its sensors, home the axes, then start again. Nothing was armed.</source>
        <translation>Prüfen Sie die Sensoren, referenzieren Sie die Achsen und starten Sie neu. Nichts wurde freigegeben.</translation>
    </message>
    <message>
        <source>&apos;line&apos; must be &apos;solid&apos;, &apos;dash&apos;, &apos;dot&apos; or &apos;dash-dot&apos;</source>
        <translation>„line“ muss „solid“, „dash“, „dot“ oder „dash-dot“ sein</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a curve has colour, line, name</source>
        <translation>unbekannter Schlüssel „{}“; eine Kurve hat colour, line, name</translation>
    </message>
    <message>
        <source>&apos;curves&apos; must be a table of signals, [monitor.curves]</source>
        <translation>„curves“ muss eine Tabelle von Signalen sein, [monitor.curves]</translation>
    </message>
    <message>
        <source>Coulomb friction</source>
        <translation>Coulomb-Reibung</translation>
    </message>
    <message>
        <source>this device has several axes, but its identification is of one</source>
        <translation>dieses Gerät hat mehrere Achsen, aber seine Identifikation ist von einer</translation>
    </message>
    <message>
        <source>update the program</source>
        <translation>aktualisieren Sie das Programm</translation>
    </message>
    <message>
        <source>there is no loop to shape yet</source>
        <translation>es gibt noch keinen Regelkreis zu formen</translation>
    </message>
    <message>
        <source>choose a method first</source>
        <translation>wählen Sie zuerst ein Verfahren</translation>
    </message>
    <message>
        <source>the loop of axis {} is still computed</source>
        <translation>der Regelkreis der Achse {} wird noch berechnet</translation>
    </message>
    <message>
        <source>wait until its verdict is there</source>
        <translation>warten Sie, bis sein Urteil da ist</translation>
    </message>
    <message>
        <source>the gains of the device are not known</source>
        <translation>die Verstärkungen des Geräts sind nicht bekannt</translation>
    </message>
    <message>
        <source>connect it and wait until its values are read</source>
        <translation>verbinden Sie es und warten Sie, bis seine Werte gelesen sind</translation>
    </message>
    <message>
        <source>Stable with little reserve: check the warnings</source>
        <translation>Stabil mit wenig Reserve: Warnungen prüfen</translation>
    </message>
    <message>
        <source>Command of law and excitation about the vertical</source>
        <translation>Stellgröße aus Regler und Anregung um die Hochachse</translation>
    </message>
    <message>
        <source>Command of law and excitation along y</source>
        <translation>Stellgröße aus Regler und Anregung entlang y</translation>
    </message>
    <message>
        <source>Command of law and excitation along x</source>
        <translation>Stellgröße aus Regler und Anregung entlang x</translation>
    </message>
    <message>
        <source>Deviation of a reading: noise</source>
        <translation>Abweichung einer Messung: Rauschen</translation>
    </message>
    <message>
        <source>Deviation that errors of the calibration leave in a reading</source>
        <translation>Abweichung einer Messung durch Restfehler der Kalibrierung</translation>
    </message>
    <message>
        <source>From line to line, along y</source>
        <translation>Von Zeile zu Zeile, entlang y</translation>
    </message>
    <message>
        <source>Largest acceleration on the path</source>
        <translation>Größte Beschleunigung auf der Bahn</translation>
    </message>
    <message>
        <source>Largest jerk on the path</source>
        <translation>Größter Ruck auf der Bahn</translation>
    </message>
    <message>
        <source>Largest speed on the path</source>
        <translation>Größte Geschwindigkeit auf der Bahn</translation>
    </message>
    <message>
        <source>Length of a line, along x</source>
        <translation>Länge einer Zeile entlang x</translation>
    </message>
    <message>
        <source>Of the circle</source>
        <translation>Des Kreises</translation>
    </message>
    <message>
        <source>Of the raster</source>
        <translation>Des Rasters</translation>
    </message>
    <message>
        <source>Speed along the path: with jumps of the acceleration or with a largest jerk</source>
        <translation>Geschwindigkeit auf der Bahn: mit Sprüngen der Beschleunigung oder mit begrenztem Ruck</translation>
    </message>
    <message>
        <source>Largest acceleration of trapezoid and S-curve, per second squared</source>
        <translation>Größte Beschleunigung von Trapez und S-Kurve, je Sekunde zum Quadrat</translation>
    </message>
    <message>
        <source>Largest jerk of the S-curve, per second cubed</source>
        <translation>Größter Ruck der S-Kurve, je Sekunde hoch drei</translation>
    </message>
    <message>
        <source>Slope of the ramp, speed of trapezoid and S-curve, per second</source>
        <translation>Steigung der Rampe, Geschwindigkeit von Trapez und S-Kurve, je Sekunde</translation>
    </message>
    <message>
        <source>Where the reference goes in mode position: to the law, or added to its command</source>
        <translation>Ziel des Sollwerts im Modus Position: zum Regler, oder addiert zu dessen Stellgröße</translation>
    </message>
    <message>
        <source>Amplitudes of the harmonics (4,2), (6,2), (6,6), (10,10) at 50 mm</source>
        <translation>Amplituden der Harmonischen (4,2), (6,2), (6,6), (10,10) bei 50 mm</translation>
    </message>
    <message>
        <source>force or torque</source>
        <translation>Kraft oder Drehmoment</translation>
    </message>
    <message>
        <source>raster</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>s-curve</source>
        <translation>S-Kurve</translation>
    </message>
    <message>
        <source>path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>use calibrate or record</source>
        <translation>verwenden Sie calibrate oder record</translation>
    </message>
    <message>
        <source>this device senses and does not drive: there is nothing to identify</source>
        <translation>dieses Gerät misst und treibt nicht an: es gibt nichts zu identifizieren</translation>
    </message>
    <message>
        <source>comes to rest</source>
        <translation>kommt zur Ruhe</translation>
    </message>
    <message>
        <source>Its catalogue needs position, current.coil1 to 6 and hall.x1 to y3.</source>
        <translation>Sein Katalog braucht position, current.coil1 bis 6 und hall.x1 bis y3.</translation>
    </message>
    <message>
        <source>the device lacks a signal of the platen</source>
        <translation>dem Gerät fehlt ein Signal der Platte</translation>
    </message>
    <message>
        <source>no rows came from the device</source>
        <translation>vom Gerät kamen keine Zeilen</translation>
    </message>
    <message>
        <source>sweeps over a pitch</source>
        <translation>Durchlauf über eine Teilung</translation>
    </message>
    <message>
        <source>goes to the start of a line</source>
        <translation>fährt zum Anfang einer Linie</translation>
    </message>
    <message>
        <source>goes to the next line</source>
        <translation>fährt zur nächsten Linie</translation>
    </message>
    <message>
        <source>sweeps at constant speed</source>
        <translation>Durchläufe mit fester Geschwindigkeit</translation>
    </message>
    <message>
        <source>goes to a place between</source>
        <translation>fährt zu einem Ort dazwischen</translation>
    </message>
    <message>
        <source>goes back</source>
        <translation>fährt zurück</translation>
    </message>
    <message>
        <source>goes to a line</source>
        <translation>fährt zu einer Linie</translation>
    </message>
    <message>
        <source>give the one that is known better; the other is then measured</source>
        <translation>geben Sie die besser bekannte an; die andere wird dann gemessen</translation>
    </message>
    <message>
        <source>one given constant is enough: m or Iz</source>
        <translation>eine gegebene Konstante genügt: m oder Iz</translation>
    </message>
    <message>
        <source>leave them out; this device takes an axis and a given m or Iz</source>
        <translation>lassen Sie diese weg; dieses Gerät nimmt eine Achse und ein gegebenes m oder Iz</translation>
    </message>
    <message>
        <source>{} = {} must be positive</source>
        <translation>{} = {} muss positiv sein</translation>
    </message>
    <message>
        <source>known are m (kg) and Iz (kg*m^2)</source>
        <translation>bekannt sind m (kg) und Iz (kg*m^2)</translation>
    </message>
    <message>
        <source>the platen has no constant &apos;{}&apos;</source>
        <translation>die Platte hat keine Konstante &apos;{}&apos;</translation>
    </message>
    <message>
        <source>{} of {} windows of the motion miss rows</source>
        <translation>in {} von {} Fenstern der Bewegung fehlen Zeilen</translation>
    </message>
    <message>
        <source>Set coil.force_constant to {}; the published model leaves out the corners of the windings.</source>
        <translation>Setzen Sie coil.force_constant auf {}; das veröffentlichte Modell lässt die Ecken der Wicklungen weg.</translation>
    </message>
    <message>
        <source>the board counts with {} N/A, the coils give {} N/A</source>
        <translation>das Steuergerät rechnet mit {} N/A, die Spulen geben {} N/A</translation>
    </message>
    <message>
        <source>Set platen.inertia and feedforward.phi.inertia to it, and tune phi again: its loop gain is off by the same factor.</source>
        <translation>Setzen Sie platen.inertia und feedforward.phi.inertia darauf, und legen Sie phi neu aus: seine Kreisverstärkung ist um denselben Faktor falsch.</translation>
    </message>
    <message>
        <source>the board&apos;s inertia of {} kg m^2 is contradicted: with {} kg the motion shows {} kg m^2 ({} to {})</source>
        <translation>der Trägheit des Steuergeräts von {} kg m^2 wird widersprochen: mit {} kg zeigt die Bewegung {} kg m^2 ({} bis {})</translation>
    </message>
    <message>
        <source>Weigh the platen and give its mass: --given m=0.64, in an experiment given = { m = 0.64 }.</source>
        <translation>Wiegen Sie die Platte und geben Sie ihre Masse an: --given m=0.64, in einem Experiment given = { m = 0.64 }.</translation>
    </message>
    <message>
        <source>only ratios follow from the motion: mass, inertia, damping and force constants have no absolute value</source>
        <translation>aus der Bewegung folgen nur Verhältnisse: Masse, Trägheit, Dämpfung und Kraftkonstanten haben keinen absoluten Wert</translation>
    </message>
    <message>
        <source>lag of the currents behind the board&apos;s outputs</source>
        <translation>Verzug der Ströme hinter den Ausgängen des Steuergeräts</translation>
    </message>
    <message>
        <source>centre of mass along y&apos;</source>
        <translation>Schwerpunkt entlang y&apos;</translation>
    </message>
    <message>
        <source>centre of mass along x&apos;</source>
        <translation>Schwerpunkt entlang x&apos;</translation>
    </message>
    <message>
        <source>friction of {}</source>
        <translation>Reibung von {}</translation>
    </message>
    <message>
        <source>stiffness of the cable, {}</source>
        <translation>Steifigkeit des Kabels, {}</translation>
    </message>
    <message>
        <source>damping of {}</source>
        <translation>Dämpfung von {}</translation>
    </message>
    <message>
        <source>{}, over mass</source>
        <translation>{}, über Masse</translation>
    </message>
    <message>
        <source>force constant of coils 5 and 6</source>
        <translation>Kraftkonstante der Spulen 5 und 6</translation>
    </message>
    <message>
        <source>force constant of coils 3 and 4</source>
        <translation>Kraftkonstante der Spulen 3 und 4</translation>
    </message>
    <message>
        <source>force constant of coils 1 and 2</source>
        <translation>Kraftkonstante der Spulen 1 und 2</translation>
    </message>
    <message>
        <source>inertia about the vertical</source>
        <translation>Trägheit um die Senkrechte</translation>
    </message>
    <message>
        <source>moving mass</source>
        <translation>bewegte Masse</translation>
    </message>
    <message>
        <source>inertia over mass</source>
        <translation>Trägheit über Masse</translation>
    </message>
    <message>
        <source>Nothing to do: an air film has none.</source>
        <translation>Nichts zu tun: ein Luftfilm hat keine.</translation>
    </message>
    <message>
        <source>axis {}: friction is below the resolution, at most {} {}</source>
        <translation>Achse {}: die Reibung liegt unter der Auflösung, höchstens {} {}</translation>
    </message>
    <message>
        <source>Design with the upper bound, or identify again with more room.</source>
        <translation>Legen Sie mit der oberen Schranke aus, oder identifizieren Sie mit mehr Raum neu.</translation>
    </message>
    <message>
        <source>axis {}: damping is below the resolution, at most {} 1/s</source>
        <translation>Achse {}: die Dämpfung liegt unter der Auflösung, höchstens {} 1/s</translation>
    </message>
    <message>
        <source>The motion does not excite the axis enough: check that nothing holds the platen.</source>
        <translation>Die Bewegung regt die Achse zu wenig an: prüfen Sie, ob etwas die Platte festhält.</translation>
    </message>
    <message>
        <source>axis {}: the acceleration per effort is {} +- {} {}</source>
        <translation>Achse {}: die Beschleunigung je Stellgröße ist {} +- {} {}</translation>
    </message>
    <message>
        <source>stiffness over inertia of {}</source>
        <translation>Steifigkeit über Trägheit von {}</translation>
    </message>
    <message>
        <source>Check that the signals are those of a platen.</source>
        <translation>Prüfen Sie, ob die Signale die einer Platte sind.</translation>
    </message>
    <message>
        <source>the equations of motion have no solution</source>
        <translation>die Bewegungsgleichungen haben keine Lösung</translation>
    </message>
    <message>
        <source>{} whole windows of motion are too few, {} had missing rows</source>
        <translation>{} ganze Fenster der Bewegung sind zu wenige, in {} fehlten Zeilen</translation>
    </message>
    <message>
        <source>the motion does not tell the constants apart</source>
        <translation>die Bewegung unterscheidet die Konstanten nicht</translation>
    </message>
    <message>
        <source>Give it more room, or check that the currents flow.</source>
        <translation>Geben Sie ihr mehr Raum, oder prüfen Sie, ob die Ströme fließen.</translation>
    </message>
    <message>
        <source>the motion does not excite every axis</source>
        <translation>die Bewegung regt nicht jede Achse an</translation>
    </message>
    <message>
        <source>choose hall, stray or all; identify gives a bound of the friction</source>
        <translation>wählen Sie hall, stray oder all; identify gibt eine Schranke der Reibung</translation>
    </message>
    <message>
        <source>a platen on air has no static friction to calibrate</source>
        <translation>eine Platte auf Luft hat keine Haftreibung zum Kalibrieren</translation>
    </message>
    <message>
        <source>Check the chips: one may be damaged or loose, or iron is near.</source>
        <translation>Prüfen Sie die Chips: einer kann beschädigt oder lose sein, oder Eisen ist in der Nähe.</translation>
    </message>
    <message>
        <source>Move it nearer to the middle, or widen window.x and window.y. Nothing was armed.</source>
        <translation>Bringen Sie sie näher an die Mitte, oder erweitern Sie window.x und window.y. Nichts wurde freigegeben.</translation>
    </message>
    <message>
        <source>Check its amplifier and the link.</source>
        <translation>Prüfen Sie ihren Verstärker und die Verbindung.</translation>
    </message>
    <message>
        <source>coil {} carried no pulses of current</source>
        <translation>Spule {} führte keine Stromimpulse</translation>
    </message>
    <message>
        <source>Check the chips and the motion.</source>
        <translation>Prüfen Sie die Chips und die Bewegung.</translation>
    </message>
    <message>
        <source>the calibration of the chips is not determined</source>
        <translation>die Kalibrierung der Chips ist nicht bestimmt</translation>
    </message>
    <message>
        <source>Check the chips: one may be dead, stuck or clipped.</source>
        <translation>Prüfen Sie die Chips: einer kann tot, hängen geblieben oder übersteuert sein.</translation>
    </message>
    <message>
        <source>the calibration of the chips does not converge</source>
        <translation>die Kalibrierung der Chips konvergiert nicht</translation>
    </message>
    <message>
        <source>Record at least 200.</source>
        <translation>Zeichnen Sie mindestens 200 auf.</translation>
    </message>
    <message>
        <source>{} samples are too few</source>
        <translation>{} Abtastwerte sind zu wenige</translation>
    </message>
    <message>
        <source>Start nearer to the middle, or widen window.x and window.y.</source>
        <translation>Beginnen Sie näher an der Mitte, oder erweitern Sie window.x und window.y.</translation>
    </message>
    <message>
        <source>the motion covers {} mm, less than the pitch of {} mm</source>
        <translation>die Bewegung umfasst {} mm, weniger als die Teilung von {} mm</translation>
    </message>
    <message>
        <source>Halbach torque motor</source>
        <translation>Halbach-Drehmomentmotor</translation>
    </message>
    <message>
        <source>use --device sim:htm</source>
        <translation>verwenden Sie --device sim:htm</translation>
    </message>
    <message>
        <source>the parts of a motor are known of a simulated one only</source>
        <translation>die Teile eines Motors sind nur von einem simulierten bekannt</translation>
    </message>
    <message>
        <source>{}: gains of several axes, not of a single loop</source>
        <translation>{}: Reglerparameter mehrerer Achsen, nicht eines einzelnen Regelkreises</translation>
    </message>
    <message>
        <source>{} % of the axes within the model&apos;s uncertainty are unstable with this loop</source>
        <translation>{} % der Achsen innerhalb der Modellunsicherheit sind mit diesem Kreis instabil</translation>
    </message>
    <message>
        <source>the model has no covariance: robustness assumes an exactly known axis</source>
        <translation>das Modell hat keine Kovarianz: Die Robustheit setzt eine genau bekannte Achse voraus</translation>
    </message>
    <message>
        <source>only the integral action removes the standstill error, slowly; a larger K_P narrows the band</source>
        <translation>nur der I-Anteil beseitigt den Stillstandsfehler, langsam; größeres K_P verkleinert das Band</translation>
    </message>
    <message>
        <source>reduce the set-point weight, or use a slower loop</source>
        <translation>Sollwertgewichtung verringern, oder einen langsameren Kreis verwenden</translation>
    </message>
    <message>
        <source>with friction and the effort limit of {} {} a step of {} is not settled after {} s</source>
        <translation>mit Reibung und der Stellgrenze von {} {} ist ein Sprung von {} nach {} s nicht eingeschwungen</translation>
    </message>
    <message>
        <source>stable above {} times these gains</source>
        <translation>stabil oberhalb des {}-Fachen dieser Reglerparameter</translation>
    </message>
    <message>
        <source>stable below {} times these gains</source>
        <translation>stabil unterhalb des {}-Fachen dieser Reglerparameter</translation>
    </message>
    <message>
        <source>no common factor on these gains gives stability: change their ratio</source>
        <translation>kein gemeinsamer Faktor auf diese Reglerparameter ergibt Stabilität: ihr Verhältnis ändern</translation>
    </message>
    <message>
        <source>procedure {} for a single loop is not available for this device; nothing was armed</source>
        <translation>Ablauf {} für einen einzelnen Regelkreis ist für dieses Gerät nicht verfügbar; nichts wurde freigegeben</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>eine davon entfernen</translation>
    </message>
    <message>
        <source>axis {} occurs twice in the model</source>
        <translation>Achse {} kommt im Modell doppelt vor</translation>
    </message>
    <message>
        <source>the covariance contains &apos;{}&apos;, which is not a quantity of the model or occurs twice</source>
        <translation>die Kovarianz enthält &apos;{}&apos;, das keine Größe des Modells ist oder doppelt vorkommt</translation>
    </message>
    <message>
        <source>axis {}: unknown {}</source>
        <translation>Achse {}: {} unbekannt</translation>
    </message>
    <message>
        <source>axis {}: &quot;{}&quot; is not a position unit</source>
        <translation>Achse {}: &quot;{}&quot; ist keine Positionseinheit</translation>
    </message>
    <message>
        <source>use the unit of the axis</source>
        <translation>Einheit der Achse verwenden</translation>
    </message>
    <message>
        <source>measured motion of axis {} outside the predicted band at {} s, by {} {}</source>
        <translation>gemessene Bewegung der Achse {} außerhalb des vorhergesagten Bands bei {} s, um {} {}</translation>
    </message>
    <message>
        <source>Old values restored. Identify the axes again, or use lower gains.</source>
        <translation>Alte Werte wiederhergestellt. Achsen neu identifizieren oder kleinere Reglerparameter verwenden.</translation>
    </message>
    <message>
        <source>motion of axis {} meanwhile: {} {}, allowed {} {}</source>
        <translation>Bewegung der Achse {} währenddessen: {} {}, erlaubt {} {}</translation>
    </message>
    <message>
        <source>assess them with the model of those axes</source>
        <translation>mit dem Modell jener Achsen beurteilen</translation>
    </message>
    <message>
        <source>use a higher frequency or more damping</source>
        <translation>höhere Frequenz oder mehr Dämpfung verwenden</translation>
    </message>
    <message>
        <source>damping rate of this axis {} 1/s, above that of poles at {} rad/s with zeta = {}</source>
        <translation>Dämpfungsrate dieser Achse {} 1/s, größer als die von Polen bei {} rad/s mit zeta = {}</translation>
    </message>
    <message>
        <source>linear-quadratic regulator, error and effort weights for the requested frequency</source>
        <translation>linear-quadratischer Regler, Gewichte für Fehler und Stellgröße für die gewünschte Frequenz</translation>
    </message>
    <message>
        <source>fastest loop of this structure with the requested phase margin</source>
        <translation>schnellster Kreis dieser Struktur mit der gewünschten Phasenreserve</translation>
    </message>
    <message>
        <source>PID with the requested pole pair, set-point weight and filter</source>
        <translation>PID mit dem gewünschten Polpaar, Sollwertgewichtung und Filter</translation>
    </message>
    <message>
        <source>recommended for this axis</source>
        <translation>empfohlen für diese Achse</translation>
    </message>
    <message>
        <source>design method &apos;{}&apos; is not available for this axis</source>
        <translation>Entwurfsmethode &apos;{}&apos; ist für diese Achse nicht verfügbar</translation>
    </message>
    <message>
        <source>use 30 to 60 deg</source>
        <translation>30 bis 60 deg verwenden</translation>
    </message>
    <message>
        <source>no loop of this structure has a phase margin of {} deg on this axis</source>
        <translation>kein Kreis dieser Struktur hat an dieser Achse eine Phasenreserve von {} deg</translation>
    </message>
    <message>
        <source>check with tune --gains FILE --apply DEVICE; otherwise save the control law as C code</source>
        <translation>mit tune --gains FILE --apply DEVICE prüfen; sonst das Regelgesetz als C-Code speichern</translation>
    </message>
    <message>
        <source>these gains need a device whose control law has set-point weights and filters</source>
        <translation>diese Reglerparameter brauchen ein Gerät, dessen Regelgesetz Sollwertgewichtung und Filter hat</translation>
    </message>
    <message>
        <source>remove it from the gains, or save the control law as C code for another controller</source>
        <translation>aus den Reglerparametern entfernen, oder das Regelgesetz als C-Code für einen anderen Regler speichern</translation>
    </message>
    <message>
        <source>the control law of this device has no {}</source>
        <translation>das Regelgesetz dieses Geräts hat kein {}</translation>
    </message>
    <message>
        <source>derivative filter</source>
        <translation>Filter des D-Anteils</translation>
    </message>
    <message>
        <source>apply the gains in one step: this removes them</source>
        <translation>Reglerparameter auf einmal übernehmen: das entfernt sie</translation>
    </message>
    <message>
        <source>the device&apos;s control law has set-point weights or filters</source>
        <translation>das Regelgesetz des Geräts hat Sollwertgewichtung oder Filter</translation>
    </message>
    <message>
        <source>switch gradual applying off</source>
        <translation>schrittweises Übernehmen ausschalten</translation>
    </message>
    <message>
        <source>gains with set-point weights or filters cannot be applied gradually</source>
        <translation>Reglerparameter mit Sollwertgewichtung oder Filtern lassen sich nicht schrittweise übernehmen</translation>
    </message>
    <message>
        <source>Use the magnet turned by 90 degrees about its shaft for the opposite polarity.</source>
        <translation>Für die umgekehrte Polung den um 90 Grad um seine Welle gedrehten Magneten verwenden.</translation>
    </message>
    <message>
        <source>The coverage proof was stopped.</source>
        <translation>Der Abdeckungsnachweis wurde gestoppt.</translation>
    </message>
    <message>
        <source>a section is defined by its sampled coefficients</source>
        <translation>ein Glied ist durch seine abgetasteten Koeffizienten definiert</translation>
    </message>
    <message>
        <source>the motion does not separate the forces</source>
        <translation>die Bewegung trennt die Kräfte nicht</translation>
    </message>
    <message>
        <source>model inadequate: the speed dependence of friction follows no known law</source>
        <translation>Modell unzureichend: Die Drehzahlabhängigkeit der Reibung folgt keinem bekannten Gesetz</translation>
    </message>
    <message>
        <source>model inadequate: the damping changes during the recording</source>
        <translation>Modell unzureichend: Die Dämpfung ändert sich während der Aufzeichnung</translation>
    </message>
    <message>
        <source>phi is too small by up to a few per cent: calibrate the stray field, then identify again</source>
        <translation>phi ist um bis zu einige Prozent zu klein: Streufeld kalibrieren, dann neu identifizieren</translation>
    </message>
    <message>
        <source>damping changes with the current: the torque angle depends on it, typical for a wrong stray-field compensation</source>
        <translation>die Dämpfung ändert sich mit dem Strom: Der Momentenwinkel hängt davon ab, typisch für eine falsche Streufeldkompensation</translation>
    </message>
    <message>
        <source>c, K_f and phi are valid at high speed without this term; near standstill friction is higher</source>
        <translation>c, K_f und phi gelten bei hoher Drehzahl ohne diesen Term; nahe dem Stillstand ist die Reibung größer</translation>
    </message>
    <message>
        <source>c, K_f and phi are given without this term; the tuning model has no quadratic drag</source>
        <translation>c, K_f und phi gelten ohne diesen Term; das Auslegungsmodell hat keinen quadratischen Widerstand</translation>
    </message>
    <message>
        <source>quadratic drag of the speed, {}</source>
        <translation>quadratischer Widerstand der Drehzahl, {}</translation>
    </message>
    <message>
        <source>the intervals do not include this error: use the relevant speeds, warm up the bearings first, and check the residuals</source>
        <translation>die Intervalle enthalten diesen Fehler nicht: die relevanten Drehzahlen verwenden, Lager zuerst warmlaufen lassen und die Residuen prüfen</translation>
    </message>
    <message>
        <source>calibrate the sensors; check for an unreported delay</source>
        <translation>Sensoren kalibrieren; auf nicht gemeldete Totzeit prüfen</translation>
    </message>
    <message>
        <source>negative damping from the oscillation, not possible for a motor</source>
        <translation>negative Dämpfung aus der Schwingung, für einen Motor nicht möglich</translation>
    </message>
    <message>
        <source>as many unknowns as segments: the friction scatter between segments is assumed (3.3 % of the friction torque), not measured</source>
        <translation>so viele Unbekannte wie Abschnitte: Die Reibungsstreuung zwischen den Abschnitten ist angenommen (3.3 % des Reibmoments), nicht gemessen</translation>
    </message>
    <message>
        <source>settling; final speed extrapolated</source>
        <translation>schwingt sich ein; Enddrehzahl extrapoliert</translation>
    </message>
    <message>
        <source>record again; allowed loss: one row in ten</source>
        <translation>neu aufzeichnen; erlaubter Verlust: jede zehnte Zeile</translation>
    </message>
    <message>
        <source>no packet was lost or damaged: the device skipped or delayed rows</source>
        <translation>kein Paket ging verloren oder war beschädigt: Das Gerät ließ Zeilen aus oder verzögerte sie</translation>
    </message>
    <message>
        <source>{} % of the frames were damaged on the line</source>
        <translation>{} % der Rahmen wurden auf der Leitung beschädigt</translation>
    </message>
    <message>
        <source>the device clock restarted: the recording has a gap, measured with the computer clock</source>
        <translation>die Geräteuhr startete neu: Die Aufzeichnung hat eine Lücke, gemessen mit der Computeruhr</translation>
    </message>
    <message>
        <source>valid if the rotor turns by less than half of this angle between two rows</source>
        <translation>gültig, wenn der Rotor sich zwischen zwei Zeilen um weniger als die Hälfte dieses Winkels dreht</translation>
    </message>
    <message>
        <source>angle wraps after {} deg: unwrapped</source>
        <translation>Winkel springt nach {} deg: abgewickelt</translation>
    </message>
    <message>
        <source>the angle column looks like a speed: it settles with each current</source>
        <translation>die Winkelspalte sieht nach einer Drehzahl aus: Sie schwingt sich mit jedem Strom ein</translation>
    </message>
    <message>
        <source>use larger and more different currents, each for a longer time</source>
        <translation>größere und verschiedenere Ströme verwenden, jeden länger</translation>
    </message>
    <message>
        <source>the interval of torque constant or inertia includes zero</source>
        <translation>das Intervall von Drehmomentkonstante oder Trägheitsmoment enthält null</translation>
    </message>
    <message>
        <source>negative inertia, not possible for a rotor</source>
        <translation>negatives Trägheitsmoment, für einen Rotor nicht möglich</translation>
    </message>
    <message>
        <source>negative torque constant: the current accelerates the rotor backwards</source>
        <translation>negative Drehmomentkonstante: Der Strom beschleunigt den Rotor rückwärts</translation>
    </message>
    <message>
        <source>current and angle are not consistent: check units, time shift of the columns, and that nothing else drives the rotor</source>
        <translation>Strom und Winkel sind nicht konsistent: Einheiten und Zeitversatz der Spalten prüfen und dass nichts anderes den Rotor antreibt</translation>
    </message>
    <message>
        <source>damping undetermined: between zero and {} % of the largest torque</source>
        <translation>Dämpfung unbestimmt: zwischen null und {} % des größten Drehmoments</translation>
    </message>
    <message>
        <source>damping not distinguishable from zero: at most {} % of the torque</source>
        <translation>Dämpfung nicht von null unterscheidbar: höchstens {} % des Drehmoments</translation>
    </message>
    <message>
        <source>friction undetermined: between zero and {} % of the largest torque</source>
        <translation>Reibung unbestimmt: zwischen null und {} % des größten Drehmoments</translation>
    </message>
    <message>
        <source>friction not distinguishable from zero: at most {} % of the torque</source>
        <translation>Reibung nicht von null unterscheidbar: höchstens {} % des Drehmoments</translation>
    </message>
    <message>
        <source>negative friction, not possible for a motor</source>
        <translation>negative Reibung, für einen Motor nicht möglich</translation>
    </message>
    <message>
        <source>invert the sign of one of the two columns (or of the command on the device), then identify again</source>
        <translation>Vorzeichen einer der beiden Spalten (oder des Befehls im Gerät) umkehren, dann neu identifizieren</translation>
    </message>
    <message>
        <source>check the loop delay and that nothing else drives the rotor</source>
        <translation>Totzeit des Kreises prüfen und dass nichts anderes den Rotor antreibt</translation>
    </message>
    <message>
        <source>negative damping, not possible for a motor</source>
        <translation>negative Dämpfung, für einen Motor nicht möglich</translation>
    </message>
    <message>
        <source>the interval of phi/J includes zero</source>
        <translation>das Intervall von phi/J enthält null</translation>
    </message>
    <message>
        <source>invert one of the two signs on the device, then measure again</source>
        <translation>eines der beiden Vorzeichen im Gerät umkehren, dann neu messen</translation>
    </message>
    <message>
        <source>wrong sign of current or angle: negative torque constant</source>
        <translation>falsches Vorzeichen von Strom oder Winkel: negative Drehmomentkonstante</translation>
    </message>
    <message>
        <source>identify the motor with the present delay of the device</source>
        <translation>Motor mit der jetzigen Totzeit des Geräts identifizieren</translation>
    </message>
    <message>
        <source>use a faster loop, or one with more integral action</source>
        <translation>schnelleren Kreis verwenden, oder einen mit mehr I-Anteil</translation>
    </message>
    <message>
        <source>with friction and current limit a step of {} deg is not settled after {} s: overshoot unknown</source>
        <translation>mit Reibung und Stromgrenze ist ein Sprung von {} deg nach {} s nicht eingeschwungen: Überschwingen unbekannt</translation>
    </message>
    <message>
        <source>use gains with faster poles, or a longer sampling period</source>
        <translation>Reglerparameter mit schnelleren Polen oder eine längere Abtastperiode verwenden</translation>
    </message>
    <message>
        <source>no figures of the step: its slowest part decays by {} per sample, too slow to simulate</source>
        <translation>keine Kennzahlen des Sprungs: Sein langsamster Teil klingt je Abtastung um {} ab, zu langsam für die Simulation</translation>
    </message>
    <message>
        <source>what-if needs a sampling period of whole milliseconds</source>
        <translation>„Was-wäre-wenn“ braucht eine Abtastperiode von ganzen Millisekunden</translation>
    </message>
    <message>
        <source>a step of {} s cannot be simulated with a sampling period of {} s</source>
        <translation>ein Sprung von {} s ist mit einer Abtastperiode von {} s nicht simulierbar</translation>
    </message>
    <message>
        <source>the file is not changed; move &apos;{}&apos; away to read the data without checksum</source>
        <translation>die Datei bleibt unverändert; &apos;{}&apos; verschieben, um die Daten ohne Prüfsumme zu lesen</translation>
    </message>
    <message>
        <source>the file is not changed: its content can be read as text</source>
        <translation>die Datei bleibt unverändert: Ihr Inhalt ist als Text lesbar</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no undamaged row</source>
        <translation>&apos;{}&apos; hat keine unbeschädigte Zeile</translation>
    </message>
    <message>
        <source>one signal at {} Hz is not possible: maximum of device and link {} Hz</source>
        <translation>ein Signal mit {} Hz ist nicht möglich: Maximum von Gerät und Verbindung {} Hz</translation>
    </message>
    <message>
        <source>omit it to use these gains; weights and filters are assessed by &apos;halbench analyse&apos; and &apos;halbench tune --gains&apos;</source>
        <translation>weglassen, um diese Reglerparameter zu verwenden; Gewichte und Filter beurteilen &apos;halbench analyse&apos; und &apos;halbench tune --gains&apos;</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a display unit of this signal; available: {}</source>
        <translation>&apos;{}&apos; ist keine Anzeigeeinheit dieses Signals; verfügbar: {}</translation>
    </message>
    <message>
        <source>{} filters exceed the maximum of {}</source>
        <translation>{} Filter überschreiten das Maximum von {}</translation>
    </message>
    <message>
        <source>add integral action, or use b = 1</source>
        <translation>I-Anteil ergänzen, oder b = 1 verwenden</translation>
    </message>
    <message>
        <source>without integral action the set-point weight b = {} gives a final value of {} times the reference</source>
        <translation>ohne I-Anteil ergibt die Sollwertgewichtung b = {} einen Endwert vom {}-Fachen der Führungsgröße</translation>
    </message>
    <message>
        <source>editing markers needs a recording with a .meta.json file</source>
        <translation>das Bearbeiten von Marken braucht eine Aufzeichnung mit .meta.json-Datei</translation>
    </message>
    <message>
        <source>another program is changing &apos;{}&apos;</source>
        <translation>ein anderes Programm ändert &apos;{}&apos;</translation>
    </message>
    <message>
        <source>not available in the device&apos;s control law</source>
        <translation>im Regelgesetz des Geräts nicht vorhanden</translation>
    </message>
    <message>
        <source>use a lower rate or fewer signals</source>
        <translation>kleinere Rate oder weniger Signale verwenden</translation>
    </message>
    <message>
        <source>use a lower rate or fewer signals; for a port that is USB up to the device, give its real speed in the address with ?baud=12000000</source>
        <translation>kleinere Rate oder weniger Signale verwenden; bei einem Port mit USB bis zum Gerät die tatsächliche Geschwindigkeit mit ?baud=12000000 in der Adresse angeben</translation>
    </message>
    <message>
        <source>{} signals at {} Hz are not possible: maximum of device and link {} Hz</source>
        <translation>{} Signale mit {} Hz sind nicht möglich: Maximum von Gerät und Verbindung {} Hz</translation>
    </message>
    <message>
        <source>check their findings</source>
        <translation>Befunde prüfen</translation>
    </message>
    <message>
        <source>these gains are rejected; nothing was written</source>
        <translation>diese Reglerparameter sind abgelehnt; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>gains for {} s and {} samples of delay, this device has {} s and {}: assessed for this device</source>
        <translation>Reglerparameter für {} s und {} Abtastungen Totzeit, dieses Gerät hat {} s und {}: für dieses Gerät beurteilt</translation>
    </message>
    <message>
        <source>compare gains of the same device</source>
        <translation>Reglerparameter desselben Geräts vergleichen</translation>
    </message>
    <message>
        <source>{}: the recorded gains have another sampling period</source>
        <translation>{}: die damaligen Reglerparameter haben eine andere Abtastperiode</translation>
    </message>
    <message>
        <source>record a move with constant gains</source>
        <translation>eine Bewegung mit konstanten Reglerparametern aufzeichnen</translation>
    </message>
    <message>
        <source>{}: the gains during the recording are not in its .meta.json file</source>
        <translation>{}: die Reglerparameter während der Aufzeichnung stehen nicht in ihrer .meta.json-Datei</translation>
    </message>
    <message>
        <source>the date is uncertain (check the clock)</source>
        <translation>das Datum ist unsicher (Uhr prüfen)</translation>
    </message>
    <message>
        <source>oscillation around a steady motion</source>
        <translation>Schwingung um eine stetige Bewegung</translation>
    </message>
    <message>
        <source>identify the motor and give its model: the plan was computed for another motor</source>
        <translation>Motor identifizieren und sein Modell angeben: Der Plan wurde für einen anderen Motor berechnet</translation>
    </message>
    <message>
        <source>speed of the rotor {} rad/s, expected {}</source>
        <translation>Drehzahl des Rotors {} rad/s, erwartet {}</translation>
    </message>
    <message>
        <source>calibrate the sensors and apply the calibration, use the model of this motor, or a smaller relay amplitude</source>
        <translation>Sensoren kalibrieren und Kalibrierung übernehmen, das Modell dieses Motors oder eine kleinere Relaisamplitude verwenden</translation>
    </message>
    <message>
        <source>omit base speed and relay amplitude, allow a higher speed or more current, or use the model of this motor</source>
        <translation>Grunddrehzahl und Relaisamplitude weglassen, höhere Drehzahl oder mehr Strom zulassen, oder das Modell dieses Motors verwenden</translation>
    </message>
    <message>
        <source>no base speed from {} to {} rad/s allows an oscillation of {} rad without nearing standstill</source>
        <translation>keine Grunddrehzahl von {} bis {} rad/s erlaubt eine Schwingung von {} rad, ohne dem Stillstand nahe zu kommen</translation>
    </message>
    <message>
        <source>at a base speed of {} rad/s no relay gives an oscillation of {} rad without nearing standstill or {} rad/s</source>
        <translation>bei einer Grunddrehzahl von {} rad/s ergibt kein Relais eine Schwingung von {} rad, ohne dem Stillstand oder {} rad/s nahe zu kommen</translation>
    </message>
    <message>
        <source>relay gain in A/rad</source>
        <translation>Relaisverstärkung in A/rad</translation>
    </message>
    <message>
        <source>relay amplitude in A</source>
        <translation>Relaisamplitude in A</translation>
    </message>
    <message>
        <source>not compared with a model of this motor</source>
        <translation>nicht mit einem Modell dieses Motors verglichen</translation>
    </message>
    <message>
        <source>agreement with the model unknown: the model has no covariance</source>
        <translation>Übereinstimmung mit dem Modell unbekannt: Das Modell hat keine Kovarianz</translation>
    </message>
    <message>
        <source>identify the motor again: it changed, or one of the results is wrong</source>
        <translation>Motor neu identifizieren: Er hat sich verändert, oder eines der Ergebnisse ist falsch</translation>
    </message>
    <message>
        <source>ultimate gain of the model {} to {} A/rad, measured {} to {}</source>
        <translation>kritische Verstärkung des Modells {} bis {} A/rad, gemessen {} bis {}</translation>
    </message>
    <message>
        <source>uncertainty of the ultimate gain {} %</source>
        <translation>Unsicherheit der kritischen Verstärkung {} %</translation>
    </message>
    <message>
        <source>ultimate gain between {} and {} A/rad: too uncertain</source>
        <translation>kritische Verstärkung zwischen {} und {} A/rad: zu unsicher</translation>
    </message>
    <message>
        <source>measure more cycles or use a larger relay gain; calibrate the sensors first</source>
        <translation>mehr Schwingungen messen oder größere Relaisverstärkung verwenden; zuerst die Sensoren kalibrieren</translation>
    </message>
    <message>
        <source>amplitude change of the oscillation {} % from the first third to the last</source>
        <translation>Amplitudenänderung der Schwingung {} % vom ersten zum letzten Drittel</translation>
    </message>
    <message>
        <source>calibrate the sensors, apply the calibration, then measure again</source>
        <translation>Sensoren kalibrieren, Kalibrierung übernehmen, dann neu messen</translation>
    </message>
    <message>
        <source>frequency drift of the oscillation {} %: excited by angle errors during rotation, allowed {} %</source>
        <translation>Frequenzdrift der Schwingung {} %: durch Winkelfehler bei der Drehung angeregt, erlaubt {} %</translation>
    </message>
    <message>
        <source>rows missing: the cycles are not consistent</source>
        <translation>Zeilen fehlen: Die Schwingungen passen nicht zusammen</translation>
    </message>
    <message>
        <source>allowed: {} deg; check for an unreported delay or a resonance</source>
        <translation>erlaubt: {} deg; auf nicht gemeldete Totzeit oder Resonanz prüfen</translation>
    </message>
    <message>
        <source>phase at the oscillation frequency {} deg, too far from -180 deg</source>
        <translation>Phase bei der Schwingfrequenz {} deg, zu weit von -180 deg</translation>
    </message>
    <message>
        <source>no ultimate gain exists; use a method with derivative action</source>
        <translation>es gibt keine kritische Verstärkung; eine Methode mit D-Anteil verwenden</translation>
    </message>
    <message>
        <source>this motor has no damping: proportional control oscillates at any gain</source>
        <translation>dieser Motor hat keine Dämpfung: P-Regelung schwingt bei jeder Verstärkung</translation>
    </message>
    <message>
        <source>use a larger relay gain, or the model of this motor</source>
        <translation>größere Relaisverstärkung verwenden, oder das Modell dieses Motors</translation>
    </message>
    <message>
        <source>only {} cycles in the recording: no limit cycle</source>
        <translation>nur {} Schwingungen in der Aufzeichnung: keine Dauerschwingung</translation>
    </message>
    <message>
        <source>check the recording for an angle error or a resonance</source>
        <translation>Aufzeichnung auf Winkelfehler oder Resonanz prüfen</translation>
    </message>
    <message>
        <source>the oscillation does not match a rotor</source>
        <translation>die Schwingung passt nicht zu einem Rotor</translation>
    </message>
    <message>
        <source>a row of the cycle contains a value that is not a number</source>
        <translation>eine Zeile der Schwingung enthält einen Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>the rows of the oscillation are not three signals of equal length</source>
        <translation>die Zeilen der Schwingung sind keine drei Signale gleicher Länge</translation>
    </message>
    <message>
        <source>give both from the relay experiment, or omit both</source>
        <translation>beide aus dem Relaisversuch angeben, oder beide weglassen</translation>
    </message>
    <message>
        <source>ultimate gain and ultimate period must be given together</source>
        <translation>kritische Verstärkung und kritische Periode müssen zusammen angegeben werden</translation>
    </message>
    <message>
        <source>use a different name for each column</source>
        <translation>für jede Spalte einen anderen Namen verwenden</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not allowed as a signal name</source>
        <translation>&apos;{}&apos; ist als Signalname nicht erlaubt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not allowed as a signal name: it is the time</source>
        <translation>&apos;{}&apos; ist als Signalname nicht erlaubt: Es ist die Zeit</translation>
    </message>
    <message>
        <source>use small steps only, or a smaller K_P</source>
        <translation>nur kleine Sprünge oder kleineres K_P verwenden</translation>
    </message>
    <message>
        <source>{} grows into a limit cycle of about +-{} deg at {} Hz</source>
        <translation>{} wächst zu einer Dauerschwingung von etwa +-{} deg bei {} Hz</translation>
    </message>
    <message>
        <source>an oscillation above +-{} deg</source>
        <translation>eine Schwingung über +-{} deg</translation>
    </message>
    <message>
        <source>use a lower value, or omit it</source>
        <translation>kleineren Wert verwenden oder weglassen</translation>
    </message>
    <message>
        <source>the target current-limit-a = {} is above the device limit of {} A</source>
        <translation>das Ziel current-limit-a = {} liegt über dem Gerätegrenzwert von {} A</translation>
    </message>
    <message>
        <source>no gains with at most {} A in a step of {} deg found for this motor; required: {} A</source>
        <translation>keine Reglerparameter mit höchstens {} A bei einem Sprung von {} deg für diesen Motor gefunden; nötig: {} A</translation>
    </message>
    <message>
        <source>no gains with a sensitivity peak up to {} found for this motor; minimum: {}</source>
        <translation>keine Reglerparameter mit einer Empfindlichkeitsspitze bis {} für diesen Motor gefunden; Minimum: {}</translation>
    </message>
    <message>
        <source>give the current limit for this step</source>
        <translation>Stromgrenze für diesen Sprung angeben</translation>
    </message>
    <message>
        <source>give the largest step without saturation, in degrees</source>
        <translation>den größten Sprung ohne Begrenzung angeben, in Grad</translation>
    </message>
    <message>
        <source>give the maximum current of the motor in A</source>
        <translation>den größten Motorstrom in A angeben</translation>
    </message>
    <message>
        <source>1.4 is robust, 1.7 usual, 2 fast</source>
        <translation>1.4 ist robust, 1.7 üblich, 2 schnell</translation>
    </message>
    <message>
        <source>minimum integral of the absolute error after a load step, with limits on Ms and current</source>
        <translation>kleinstes Integral des absoluten Fehlers nach einem Lastsprung, mit Grenzen für Ms und Strom</translation>
    </message>
    <message>
        <source>empty the trash; on a disk without trash use `halbench recordings --retain ... --delete` to delete permanently</source>
        <translation>Papierkorb leeren; auf einem Datenträger ohne Papierkorb mit `halbench recordings --retain ... --delete` endgültig löschen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be moved to the trash</source>
        <translation>&apos;{}&apos; lässt sich nicht in den Papierkorb verschieben</translation>
    </message>
    <message>
        <source>move running</source>
        <translation>Bewegung läuft</translation>
    </message>
    <message>
        <source>position hold</source>
        <translation>Position halten</translation>
    </message>
    <message>
        <source>it is checked again next time</source>
        <translation>wird beim nächsten Mal erneut geprüft</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is kept: {}</source>
        <translation>&apos;{}&apos; bleibt: {}</translation>
    </message>
    <message>
        <source>its data were changed</source>
        <translation>ihre Daten wurden verändert</translation>
    </message>
    <message>
        <source>it is less than 24 hours old</source>
        <translation>sie ist weniger als 24 Stunden alt</translation>
    </message>
    <message>
        <source>another file has the same name</source>
        <translation>eine andere Datei hat denselben Namen</translation>
    </message>
    <message>
        <source>invalid limit &apos;{}&apos; for --retain</source>
        <translation>ungültige Grenze &apos;{}&apos; für --retain</translation>
    </message>
    <message>
        <source>use e.g. --retain 30d, --retain 20GB or --retain 30d,20GB</source>
        <translation>z. B. --retain 30d, --retain 20GB oder --retain 30d,20GB verwenden</translation>
    </message>
    <message>
        <source>shorten the name or the mask to {} bytes</source>
        <translation>Namen oder Maske auf {} Bytes kürzen</translation>
    </message>
    <message>
        <source>the name of the recording would have {} bytes</source>
        <translation>der Name der Aufzeichnung hätte {} Bytes</translation>
    </message>
    <message>
        <source>omit .csv</source>
        <translation>.csv weglassen</translation>
    </message>
    <message>
        <source>the file extension is added automatically</source>
        <translation>die Dateiendung wird automatisch ergänzt</translation>
    </message>
    <message>
        <source>a name cannot begin with a space or a dot</source>
        <translation>ein Name darf nicht mit Leerzeichen oder Punkt beginnen</translation>
    </message>
    <message>
        <source>example: {}</source>
        <translation>Beispiel: {}</translation>
    </message>
    <message>
        <source>use {number} only once</source>
        <translation>{number} nur einmal verwenden</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not allowed in file names</source>
        <translation>&apos;{}&apos; ist in Dateinamen nicht erlaubt</translation>
    </message>
    <message>
        <source>enter the folder in its own field</source>
        <translation>Ordner in sein eigenes Feld eingeben</translation>
    </message>
    <message>
        <source>a name cannot contain a folder</source>
        <translation>ein Name darf keinen Ordner enthalten</translation>
    </message>
    <message>
        <source>&apos;}&apos; without &apos;{&apos;</source>
        <translation>&apos;}&apos; ohne &apos;{&apos;</translation>
    </message>
    <message>
        <source>&apos;{&apos; without &apos;}&apos;</source>
        <translation>&apos;{&apos; ohne &apos;}&apos;</translation>
    </message>
    <message>
        <source>allowed are {device}, {name}, {date}, {time} and {number}</source>
        <translation>erlaubt sind {device}, {name}, {date}, {time} und {number}</translation>
    </message>
    <message>
        <source>apply them gradually, or use gains with a larger modulus margin</source>
        <translation>schrittweise übernehmen, oder Reglerparameter mit größerer Modulreserve verwenden</translation>
    </message>
    <message>
        <source>these gains amplify model errors {} times more than the recorded gains: the band is wider by this factor</source>
        <translation>diese Reglerparameter verstärken Modellfehler {}-mal mehr als die damaligen: Das Band ist um diesen Faktor breiter</translation>
    </message>
    <message>
        <source>use stable gains</source>
        <translation>stabile Reglerparameter verwenden</translation>
    </message>
    <message>
        <source>the loop is unstable with these gains: no prediction</source>
        <translation>der Kreis ist mit diesen Reglerparametern instabil: keine Vorhersage</translation>
    </message>
    <message>
        <source>no prediction for other gains: identify the motor again, or use a recording of this motor with these gains</source>
        <translation>keine Vorhersage für andere Reglerparameter: Motor neu identifizieren, oder eine Aufzeichnung dieses Motors mit diesen Reglerparametern verwenden</translation>
    </message>
    <message>
        <source>the band is widened to contain the recording; identify the motor again for a better one</source>
        <translation>das Band ist erweitert, sodass es die Aufzeichnung enthält; für ein besseres den Motor neu identifizieren</translation>
    </message>
    <message>
        <source>the model with the recorded gains does not match the recorded move: {} % outside the predicted band</source>
        <translation>das Modell mit den damaligen Reglerparametern passt nicht zur aufgezeichneten Bewegung: {} % außerhalb des vorhergesagten Bands</translation>
    </message>
    <message>
        <source>a replay needs position, reference and current_command</source>
        <translation>eine Wiedergabe braucht position, reference und current_command</translation>
    </message>
    <message>
        <source>use a recording that begins with its move, as `halbench move --out` writes it</source>
        <translation>eine Aufzeichnung verwenden, die mit ihrer Bewegung beginnt, wie sie `halbench move --out` schreibt</translation>
    </message>
    <message>
        <source>the rotor is already moving when the recording begins</source>
        <translation>der Rotor bewegt sich bereits zu Beginn der Aufzeichnung</translation>
    </message>
    <message>
        <source>rows missing at {} s: no prediction possible</source>
        <translation>Zeilen fehlen bei {} s: keine Vorhersage möglich</translation>
    </message>
    <message>
        <source>no valid motor within the model&apos;s uncertainty</source>
        <translation>kein gültiger Motor innerhalb der Modellunsicherheit</translation>
    </message>
    <message>
        <source>more than 5 % of the measured motion outside the predicted band</source>
        <translation>mehr als 5 % der gemessenen Bewegung außerhalb des vorhergesagten Bands</translation>
    </message>
    <message>
        <source>allow larger steps, or apply intermediate gains first</source>
        <translation>größere Schritte zulassen, oder zuerst dazwischenliegende Reglerparameter übernehmen</translation>
    </message>
    <message>
        <source>the gains are more than 40 steps away</source>
        <translation>die Reglerparameter sind mehr als 40 Schritte entfernt</translation>
    </message>
    <message>
        <source>a step factor of {} is too small</source>
        <translation>ein Schrittfaktor von {} ist zu klein</translation>
    </message>
    <message>
        <source>nothing was written; use gains with larger margins, or identify more precisely</source>
        <translation>nichts wurde geschrieben; Reglerparameter mit größeren Reserven verwenden, oder genauer identifizieren</translation>
    </message>
    <message>
        <source>step {} of {} is not safe: unstable for {} % of the motors within the uncertainty, margins {} deg and {}</source>
        <translation>Schritt {} von {} ist nicht sicher: instabil für {} % der Motoren innerhalb der Unsicherheit, Reserven {} deg und {}</translation>
    </message>
    <message>
        <source>measured motion outside the predicted band at {} s, by {} degrees</source>
        <translation>gemessene Bewegung außerhalb des vorhergesagten Bands bei {} s, um {} Grad</translation>
    </message>
    <message>
        <source>wait until a picture is shown</source>
        <translation>warten, bis ein Bild gezeigt wird</translation>
    </message>
    <message>
        <source>check that the file exists</source>
        <translation>prüfen, ob die Datei existiert</translation>
    </message>
    <message>
        <source>{}: the file exists already</source>
        <translation>{}: die Datei existiert bereits</translation>
    </message>
    <message>
        <source>positions in the .meta.json file</source>
        <translation>Stellen in der .meta.json-Datei</translation>
    </message>
    <message>
        <source>times are not changed; functions that need a constant rate may reject the recording</source>
        <translation>Zeiten bleiben unverändert; Funktionen mit konstanter Rate können die Aufzeichnung ablehnen</translation>
    </message>
    <message>
        <source>uneven time steps: {} s to {} s</source>
        <translation>ungleichmäßige Zeitschritte: {} s bis {} s</translation>
    </message>
    <message>
        <source>give its unit with --unit</source>
        <translation>Einheit mit --unit angeben</translation>
    </message>
    <message>
        <source>unknown unit &apos;{}&apos; of column &apos;{}&apos;: numbers are kept without a unit</source>
        <translation>unbekannte Einheit &apos;{}&apos; der Spalte &apos;{}&apos;: Zahlen bleiben ohne Einheit</translation>
    </message>
    <message>
        <source>--time and --rate_Hz exclude each other</source>
        <translation>--time und --rate_Hz schließen sich aus</translation>
    </message>
    <message>
        <source>give the sampling rate in rows per second</source>
        <translation>Abtastrate in Zeilen je Sekunde angeben</translation>
    </message>
    <message>
        <source>numbers range from about 1e-308 to 1e308</source>
        <translation>Zahlen reichen von etwa 1e-308 bis 1e308</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is out of the number range</source>
        <translation>&apos;{}&apos; liegt außerhalb des Zahlenbereichs</translation>
    </message>
    <message>
        <source>{}:1:1: lines end with CR only</source>
        <translation>{}:1:1: Zeilen enden nur mit CR</translation>
    </message>
    <message>
        <source>zero bytes: not a text file</source>
        <translation>Nullbytes: keine Textdatei</translation>
    </message>
    <message>
        <source>a table has rows of equal length, up to two lines of names and units above, and comments beginning with #; set the format with --separator, --decimal and --header</source>
        <translation>eine Tabelle hat gleich lange Zeilen, darüber bis zu zwei Zeilen mit Namen und Einheiten, und Kommentare mit #; das Format mit --separator, --decimal und --header angeben</translation>
    </message>
    <message>
        <source>write numbers without thousands separators</source>
        <translation>Zahlen ohne Tausendertrennzeichen schreiben</translation>
    </message>
    <message>
        <source>line {} may be a row of numbers or of {}</source>
        <translation>Zeile {} kann eine Zahlenzeile oder eine Zeile mit {} sein</translation>
    </message>
    <message>
        <source> (thousands separators are not supported: remove them)</source>
        <translation> (Tausendertrennzeichen werden nicht unterstützt: entfernen)</translation>
    </message>
    <message>
        <source>the format of columns and numbers is uncertain</source>
        <translation>das Format von Spalten und Zahlen ist unsicher</translation>
    </message>
    <message>
        <source>choose the time column with --time, or give --rate_Hz</source>
        <translation>Zeitspalte mit --time wählen, oder --rate_Hz angeben</translation>
    </message>
    <message>
        <source>map another column with --map, or give its unit with --unit</source>
        <translation>andere Spalte mit --map zuordnen, oder ihre Einheit mit --unit angeben</translation>
    </message>
    <message>
        <source>choose another column with --time, or give its unit with --unit</source>
        <translation>andere Spalte mit --time wählen, oder ihre Einheit mit --unit angeben</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is in {}, which is not a time unit</source>
        <translation>Spalte &apos;{}&apos; ist in {}, keine Zeiteinheit</translation>
    </message>
    <message>
        <source>unit of its numbers: {}</source>
        <translation>Einheit ihrer Zahlen: {}</translation>
    </message>
    <message>
        <source>the unit of column &apos;{}&apos; is unknown</source>
        <translation>die Einheit der Spalte &apos;{}&apos; ist unbekannt</translation>
    </message>
    <message>
        <source>no time column: F rows per second</source>
        <translation>keine Zeitspalte: F Zeilen je Sekunde</translation>
    </message>
    <message>
        <source>the time column is uncertain</source>
        <translation>die Zeitspalte ist unsicher</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a known unit</source>
        <translation>&apos;{}&apos; ist keine bekannte Einheit</translation>
    </message>
    <message>
        <source>the model has no covariance: its uncertainty is unknown</source>
        <translation>das Modell hat keine Kovarianz: Seine Unsicherheit ist unbekannt</translation>
    </message>
    <message>
        <source>no gain margin: the magnitude at the phase crossover is completely uncertain</source>
        <translation>keine Amplitudenreserve: Der Betrag am Phasendurchtritt ist völlig unsicher</translation>
    </message>
    <message>
        <source>no phase margin: the phase at the gain crossover is completely uncertain</source>
        <translation>keine Phasenreserve: Die Phase am Durchtritt ist völlig unsicher</translation>
    </message>
    <message>
        <source>waiting for the last rows</source>
        <translation>wartet auf die letzten Zeilen</translation>
    </message>
    <message>
        <source>sweep from {} to {} Hz, {} of {}</source>
        <translation>Durchlauf von {} bis {} Hz, {} von {}</translation>
    </message>
    <message>
        <source>the generator of this device has neither multisine nor chirp</source>
        <translation>der Generator dieses Geräts hat weder Multisinus noch Chirp</translation>
    </message>
    <message>
        <source>scroll to a range with samples, or move the cursors</source>
        <translation>zu einem Bereich mit Messwerten verschieben, oder die Cursor bewegen</translation>
    </message>
    <message>
        <source>no samples of the plots in this time range</source>
        <translation>keine Messwerte der Diagramme in diesem Zeitbereich</translation>
    </message>
    <message>
        <source>zoom in, move the cursors closer, or record and cut with halbench convert</source>
        <translation>hineinzoomen, Cursor enger setzen, oder aufzeichnen und mit halbench convert schneiden</translation>
    </message>
    <message>
        <source>{} values exceed the limit for data from the plots</source>
        <translation>{} Werte überschreiten die Grenze für Daten aus den Diagrammen</translation>
    </message>
    <message>
        <source>a sweep is too short to resolve its frequencies</source>
        <translation>ein Durchlauf ist zu kurz, um seine Frequenzen aufzulösen</translation>
    </message>
    <message>
        <source>a swept row contains a value that is not a number</source>
        <translation>eine Zeile des Durchlaufs enthält einen Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>{} sweeps are too few to estimate the scatter</source>
        <translation>{} Durchläufe sind zu wenige, um die Streuung zu schätzen</translation>
    </message>
    <message>
        <source>the swept rows are not complete sweeps of three signals</source>
        <translation>die Zeilen sind keine vollständigen Durchläufe von drei Signalen</translation>
    </message>
    <message>
        <source>axes can be moved one at a time only</source>
        <translation>Achsen lassen sich nur einzeln bewegen</translation>
    </message>
    <message>
        <source>the device has several axes; no axis selected</source>
        <translation>das Gerät hat mehrere Achsen; keine Achse gewählt</translation>
    </message>
    <message>
        <source>Old values restored. Check that the link is not overloaded, then apply again.</source>
        <translation>Alte Werte wiederhergestellt. Prüfen, ob die Verbindung überlastet ist, dann erneut übernehmen.</translation>
    </message>
    <message>
        <source>only {} of {} s of the verification move were recorded</source>
        <translation>nur {} von {} s der Nachweisbewegung wurden aufgezeichnet</translation>
    </message>
    <message>
        <source>no crossover gives a stable position loop for this motor</source>
        <translation>keine Durchtrittsfrequenz ergibt einen stabilen Lageregelkreis für diesen Motor</translation>
    </message>
    <message>
        <source>unknown capture state of the device</source>
        <translation>unbekannter Erfassungszustand des Geräts</translation>
    </message>
    <message>
        <source>the device sent no data of its completed capture</source>
        <translation>das Gerät sendete keine Daten der fertigen Erfassung</translation>
    </message>
    <message>
        <source>make sure that no other program uses it, then re-arm the trigger</source>
        <translation>sicherstellen, dass kein anderes Programm sie verwendet, dann den Trigger neu scharf stellen</translation>
    </message>
    <message>
        <source>the device&apos;s capture was ended by another program</source>
        <translation>die Erfassung des Geräts wurde von einem anderen Programm beendet</translation>
    </message>
    <message>
        <source>the recording of a stream needs a level trigger</source>
        <translation>die Aufzeichnung eines Datenstroms braucht einen Pegeltrigger</translation>
    </message>
    <message>
        <source>split the file; each part begins with its first line</source>
        <translation>Datei aufteilen; jeder Teil beginnt mit ihrer ersten Zeile</translation>
    </message>
    <message>
        <source>the file may be damaged or not a recording</source>
        <translation>die Datei ist vielleicht beschädigt oder keine Aufzeichnung</translation>
    </message>
    <message>
        <source>the oldest samples are dropped when memory is full; recordings are not affected; check the folder and the disk</source>
        <translation>die ältesten Messwerte entfallen bei vollem Arbeitsspeicher; Aufzeichnungen sind nicht betroffen; Ordner und Datenträger prüfen</translation>
    </message>
    <message>
        <source>the oldest samples are dropped earlier; recordings are not affected; free disk space</source>
        <translation>die ältesten Messwerte entfallen früher; Aufzeichnungen sind nicht betroffen; Speicherplatz freigeben</translation>
    </message>
    <message>
        <source>no space for more history in &apos;{}&apos;: {}</source>
        <translation>kein Platz für weiteren Verlauf in &apos;{}&apos;: {}</translation>
    </message>
    <message>
        <source>a gap is shown instead; recordings are not affected; check the disk</source>
        <translation>stattdessen wird eine Lücke gezeigt; Aufzeichnungen sind nicht betroffen; Datenträger prüfen</translation>
    </message>
    <message>
        <source>the history in &apos;{}&apos; cannot be read: {}</source>
        <translation>der Verlauf in &apos;{}&apos; ist nicht lesbar: {}</translation>
    </message>
    <message>
        <source>use a smaller lowest frequency; the period becomes longer</source>
        <translation>kleinere niedrigste Frequenz verwenden; die Periode wird länger</translation>
    </message>
    <message>
        <source>no base speed from {} to {} rad/s separates the harmonics of the rotation from the lines: a period is only {} s</source>
        <translation>keine Grunddrehzahl von {} bis {} rad/s trennt die Harmonischen der Drehung von den Linien: Eine Periode dauert nur {} s</translation>
    </message>
    <message>
        <source>measure the response on this device</source>
        <translation>Frequenzgang an diesem Gerät messen</translation>
    </message>
    <message>
        <source>sampling period of the response {} ms, of this loop {} ms</source>
        <translation>Abtastperiode des Frequenzgangs {} ms, dieses Kreises {} ms</translation>
    </message>
    <message>
        <source>{}: points: the list is empty</source>
        <translation>{}: points: Die Liste ist leer</translation>
    </message>
    <message>
        <source>{}: points[{}]: needs a plant, and a frequency above the previous one and below half the rate</source>
        <translation>{}: points[{}]: braucht eine Strecke und eine Frequenz über der vorigen und unter der halben Rate</translation>
    </message>
    <message>
        <source>check its findings, then measure again</source>
        <translation>Befunde prüfen, dann neu messen</translation>
    </message>
    <message>
        <source>{}: this response was rejected</source>
        <translation>{}: dieser Frequenzgang wurde abgelehnt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has {} numbers, too many for the comparison</source>
        <translation>&apos;{}&apos; hat {} Zahlen, zu viele für den Vergleich</translation>
    </message>
    <message>
        <source>tags and notes need a recording with a .meta.json file</source>
        <translation>Schlagwörter und Notizen brauchen eine Aufzeichnung mit .meta.json-Datei</translation>
    </message>
    <message>
        <source>use a start time before the end</source>
        <translation>Startzeit vor dem Ende verwenden</translation>
    </message>
    <message>
        <source>use one result; the comma separates function arguments</source>
        <translation>ein Ergebnis verwenden; das Komma trennt Funktionsargumente</translation>
    </message>
    <message>
        <source>split it: a derived signal may use the derived signals before it</source>
        <translation>aufteilen: Ein abgeleitetes Signal darf die vorherigen abgeleiteten Signale verwenden</translation>
    </message>
    <message>
        <source>the expression has more than {} characters</source>
        <translation>der Ausdruck hat mehr als {} Zeichen</translation>
    </message>
    <message>
        <source>use == to compare</source>
        <translation>zum Vergleichen == verwenden</translation>
    </message>
    <message>
        <source>column {} of the expression: = is not an operator</source>
        <translation>Spalte {} des Ausdrucks: = ist kein Operator</translation>
    </message>
    <message>
        <source>column {} of the expression: unexpected &apos;{}&apos;</source>
        <translation>Spalte {} des Ausdrucks: unerwartetes &apos;{}&apos;</translation>
    </message>
    <message>
        <source>column {} of the expression: too few arguments for {}</source>
        <translation>Spalte {} des Ausdrucks: zu wenige Argumente für {}</translation>
    </message>
    <message>
        <source>column {} of the expression: too many arguments for {}</source>
        <translation>Spalte {} des Ausdrucks: zu viele Argumente für {}</translation>
    </message>
    <message>
        <source>every ? needs a :</source>
        <translation>jedes ? braucht ein :</translation>
    </message>
    <message>
        <source>column {} of the expression: missing :</source>
        <translation>Spalte {} des Ausdrucks: : fehlt</translation>
    </message>
    <message>
        <source>close every (</source>
        <translation>jede ( schließen</translation>
    </message>
    <message>
        <source>column {} of the expression: missing )</source>
        <translation>Spalte {} des Ausdrucks: ) fehlt</translation>
    </message>
    <message>
        <source>column {} of the expression: unexpected end</source>
        <translation>Spalte {} des Ausdrucks: unerwartetes Ende</translation>
    </message>
    <message>
        <source>give the unit of the result, 1 for a number; terms of a sum need equal units</source>
        <translation>Einheit des Ergebnisses angeben, 1 für eine Zahl; Summanden brauchen gleiche Einheiten</translation>
    </message>
    <message>
        <source>the unit of the expression cannot be determined</source>
        <translation>die Einheit des Ausdrucks ist nicht bestimmbar</translation>
    </message>
    <message>
        <source>column {} of the expression: unknown signal &apos;{}&apos;</source>
        <translation>Spalte {} des Ausdrucks: unbekanntes Signal &apos;{}&apos;</translation>
    </message>
    <message>
        <source>use signal names as in recordings, e.g. current.a</source>
        <translation>Signalnamen wie in Aufzeichnungen verwenden, z. B. current.a</translation>
    </message>
    <message>
        <source>the expression contains no signal</source>
        <translation>der Ausdruck enthält kein Signal</translation>
    </message>
    <message>
        <source>use letters, digits, dots and underscores; begin with a letter or underscore</source>
        <translation>Buchstaben, Ziffern, Punkte und Unterstriche verwenden; mit Buchstabe oder Unterstrich beginnen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a valid signal name</source>
        <translation>&apos;{}&apos; ist kein gültiger Signalname</translation>
    </message>
    <message>
        <source>unknown excitation &apos;{}&apos;</source>
        <translation>unbekannte Anregung &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the device uses the printed difference equation, which has no gains</source>
        <translation>das Gerät verwendet die gedruckte Differenzengleichung, die keine Reglerparameter hat</translation>
    </message>
    <message>
        <source>excitation from {} Hz</source>
        <translation>Anregung ab {} Hz</translation>
    </message>
    <message>
        <source>running up</source>
        <translation>läuft hoch</translation>
    </message>
    <message>
        <source>use a smaller amplitude or a higher base speed; if the loop oscillates by itself, use gains with more damping first</source>
        <translation>kleinere Amplitude oder höhere Grunddrehzahl verwenden; schwingt der Kreis von selbst, zuerst Reglerparameter mit mehr Dämpfung verwenden</translation>
    </message>
    <message>
        <source>the speed fell to {} rad/s at a base speed of {} rad/s: near standstill friction is not a constant offset</source>
        <translation>die Drehzahl fiel auf {} rad/s bei einer Grunddrehzahl von {} rad/s: Nahe dem Stillstand ist Reibung kein konstanter Versatz</translation>
    </message>
    <message>
        <source>use at most {} deg, a higher base speed or fewer high frequencies, or omit the amplitude</source>
        <translation>höchstens {} deg, höhere Grunddrehzahl oder weniger hohe Frequenzen verwenden, oder die Amplitude weglassen</translation>
    </message>
    <message>
        <source>an amplitude of {} deg changes the reference speed by {} rad/s at a base speed of {} rad/s: the speed would change its sign</source>
        <translation>eine Amplitude von {} deg ändert die Führungsdrehzahl um {} rad/s bei einer Grunddrehzahl von {} rad/s: Die Drehzahl würde ihr Vorzeichen wechseln</translation>
    </message>
    <message>
        <source>a base speed of {} rad/s is too low: friction is a constant offset only during rotation</source>
        <translation>eine Grunddrehzahl von {} rad/s ist zu klein: Reibung ist nur während der Drehung ein konstanter Versatz</translation>
    </message>
    <message>
        <source>minimum coherence</source>
        <translation>Mindestkohärenz</translation>
    </message>
    <message>
        <source>the intervals are widened by this factor; check for a resonance or an angle error</source>
        <translation>die Intervalle sind um diesen Faktor erweitert; auf Resonanz oder Winkelfehler prüfen</translation>
    </message>
    <message>
        <source>distance of the points from the fitted rotor: {} times their scatter</source>
        <translation>Abstand der Punkte vom angepassten Rotor: {}-fache Streuung</translation>
    </message>
    <message>
        <source>the points do not determine the constants of a rotor</source>
        <translation>die Punkte bestimmen die Konstanten eines Rotors nicht</translation>
    </message>
    <message>
        <source>switch stray.enabled on: the measured loop includes it</source>
        <translation>stray.enabled einschalten: Der gemessene Kreis enthält sie</translation>
    </message>
    <message>
        <source>stray-field compensation was on during the measurement, but is off on the device</source>
        <translation>die Streufeldkompensation war bei der Messung ein, ist im Gerät aber aus</translation>
    </message>
    <message>
        <source>the current reached its limit of {} A: the plant is valid, the closed loop was not linear</source>
        <translation>der Strom erreichte seine Grenze von {} A: Die Strecke ist gültig, der geschlossene Kreis war nicht linear</translation>
    </message>
    <message>
        <source>use more periods or a larger amplitude</source>
        <translation>mehr Perioden oder größere Amplitude verwenden</translation>
    </message>
    <message>
        <source>{} of {} frequencies have a coherence below {} and were excluded</source>
        <translation>{} von {} Frequenzen haben eine Kohärenz unter {} und wurden ausgeschlossen</translation>
    </message>
    <message>
        <source>use more periods or a larger amplitude there</source>
        <translation>dort mehr Perioden oder größere Amplitude verwenden</translation>
    </message>
    <message>
        <source>use a higher end frequency, or a lower start frequency</source>
        <translation>höhere Endfrequenz oder niedrigere Startfrequenz verwenden</translation>
    </message>
    <message>
        <source>allowed: {} dB; use more periods, and calibrate the sensor gains and the stray field first</source>
        <translation>erlaubt: {} dB; mehr Perioden verwenden und zuerst Sensorverstärkungen und Streufeld kalibrieren</translation>
    </message>
    <message>
        <source>no gain margin: between {} and {} dB, uncertainty at best {}</source>
        <translation>keine Amplitudenreserve: zwischen {} und {} dB, Unsicherheit bestenfalls {}</translation>
    </message>
    <message>
        <source>no gain margin: phase crossover in a range without valid frequencies</source>
        <translation>keine Amplitudenreserve: Phasendurchtritt in einem Bereich ohne gültige Frequenzen</translation>
    </message>
    <message>
        <source>no gain margin: no phase crossover among the valid frequencies</source>
        <translation>keine Amplitudenreserve: keine Phasendurchtrittsfrequenz bei den gültigen Frequenzen</translation>
    </message>
    <message>
        <source>allowed: {} deg; use more periods, and calibrate the sensor gains and the stray field first</source>
        <translation>erlaubt: {} deg; mehr Perioden verwenden und zuerst Sensorverstärkungen und Streufeld kalibrieren</translation>
    </message>
    <message>
        <source>no phase margin: between {} and {} deg, uncertainty at best {}</source>
        <translation>keine Phasenreserve: zwischen {} und {} deg, Unsicherheit bestenfalls {}</translation>
    </message>
    <message>
        <source>no phase margin: gain crossover in a range without valid frequencies</source>
        <translation>keine Phasenreserve: Durchtritt in einem Bereich ohne gültige Frequenzen</translation>
    </message>
    <message>
        <source>no phase margin: no gain crossover among the valid frequencies</source>
        <translation>keine Phasenreserve: kein Durchtritt bei den gültigen Frequenzen</translation>
    </message>
    <message>
        <source>rows missing near {} Hz: the periods are not consistent</source>
        <translation>Zeilen fehlen nahe {} Hz: Die Perioden passen nicht zusammen</translation>
    </message>
    <message>
        <source>check its points for an angle error or a resonance</source>
        <translation>seine Punkte auf Winkelfehler oder Resonanz prüfen</translation>
    </message>
    <message>
        <source>the measured response does not match a rotor</source>
        <translation>der gemessene Frequenzgang passt nicht zu einem Rotor</translation>
    </message>
    <message>
        <source>measure more frequencies, or with a larger amplitude</source>
        <translation>mehr Frequenzen oder mit größerer Amplitude messen</translation>
    </message>
    <message>
        <source>check that the reference generator was running</source>
        <translation>prüfen, ob der Sollwertgenerator lief</translation>
    </message>
    <message>
        <source>an excited row contains a value that is not a number</source>
        <translation>eine angeregte Zeile enthält einen Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>{} periods are too few to estimate the scatter</source>
        <translation>{} Perioden sind zu wenige, um die Streuung zu schätzen</translation>
    </message>
    <message>
        <source>the excited rows are not complete periods of three signals</source>
        <translation>die angeregten Zeilen sind keine vollständigen Perioden von drei Signalen</translation>
    </message>
    <message>
        <source>check the delay (delay.samples), or use a slower loop</source>
        <translation>Totzeit prüfen (delay.samples), oder einen langsameren Kreis verwenden</translation>
    </message>
    <message>
        <source>one more sample of delay makes this loop unstable: delay margin {} ms</source>
        <translation>eine Abtastung mehr Totzeit macht diesen Kreis instabil: Totzeitreserve {} ms</translation>
    </message>
    <message>
        <source>design &apos;{}&apos; exists already</source>
        <translation>Entwurf &apos;{}&apos; existiert bereits</translation>
    </message>
    <message>
        <source>use a lower crossover, or method lead or phase-margin</source>
        <translation>niedrigere Durchtrittsfrequenz verwenden, oder Methode lead oder phase-margin</translation>
    </message>
    <message>
        <source>this rule gives little damping: use method recommended, bandwidth or phase-margin</source>
        <translation>diese Regel ergibt wenig Dämpfung: Methode recommended, bandwidth oder phase-margin verwenden</translation>
    </message>
    <message>
        <source>use a lower bandwidth</source>
        <translation>kleinere Bandbreite verwenden</translation>
    </message>
    <message>
        <source>this rule needs a motor with damping: c/J = 0 in its model</source>
        <translation>diese Regel braucht einen Motor mit Dämpfung: c/J = 0 in seinem Modell</translation>
    </message>
    <message>
        <source>omit the filter (filter_s null): the device uses the difference of two samples; if the noise is too large, reduce K_D</source>
        <translation>Filter weglassen (filter_s null): Das Gerät verwendet die Differenz zweier Abtastwerte; bei zu viel Rauschen K_D verringern</translation>
    </message>
    <message>
        <source>the device&apos;s control law has no derivative filter; these gains have a filter of {} s</source>
        <translation>das Regelgesetz des Geräts hat kein Filter des D-Anteils; diese Reglerparameter haben ein Filter von {} s</translation>
    </message>
    <message>
        <source>PI (lag) with the requested crossover</source>
        <translation>PI (Lag) mit der gewünschten Durchtrittsfrequenz</translation>
    </message>
    <message>
        <source>PD (lead) with the requested phase margin</source>
        <translation>PD (Lead) mit der gewünschten Phasenreserve</translation>
    </message>
    <message>
        <source>same with time-weighted error: penalises long-lasting errors</source>
        <translation>ebenso mit zeitgewichtetem Fehler: bestraft lang anhaltende Fehler</translation>
    </message>
    <message>
        <source>linear-quadratic regulator, weights for the requested frequency</source>
        <translation>linear-quadratischer Regler, Gewichte für die gewünschte Frequenz</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, P: half of the ultimate gain</source>
        <translation>Ziegler und Nichols, P: halbe kritische Verstärkung</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, PI, from ultimate gain and period</source>
        <translation>Ziegler und Nichols, PI, aus kritischer Verstärkung und Periode</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, PID, from ultimate gain and period; fast starting point</source>
        <translation>Ziegler und Nichols, PID, aus kritischer Verstärkung und Periode; schneller Ausgangspunkt</translation>
    </message>
    <message>
        <source>lambda tuning: closed loop as a double lag of the requested bandwidth</source>
        <translation>Lambda-Einstellung: geschlossener Kreis als doppeltes Verzögerungsglied der gewünschten Bandbreite</translation>
    </message>
    <message>
        <source>use a lower crossover against resonance or noise: method bandwidth, or lead</source>
        <translation>gegen Resonanz oder Rauschen eine niedrigere Durchtrittsfrequenz verwenden: Methode bandwidth oder lead</translation>
    </message>
    <message>
        <source>the device&apos;s control law has no {} filter</source>
        <translation>das Regelgesetz des Geräts hat kein {}-Filter</translation>
    </message>
    <message>
        <source>the system buffers no more than {} ms of this stream; data may be lost: raise its limit (sysctl net.core.rmem_max={}), use fewer signals or a lower rate, or connect by tcp:</source>
        <translation>das System puffert höchstens {} ms dieses Datenstroms; Daten können verloren gehen: Grenze erhöhen (sysctl net.core.rmem_max={}), weniger Signale oder kleinere Rate verwenden, oder über tcp: verbinden</translation>
    </message>
    <message>
        <source>still stopped: {}</source>
        <translation>noch gestoppt: {}</translation>
    </message>
    <message>
        <source>release state unknown</source>
        <translation>Stoppzustand unbekannt</translation>
    </message>
    <message>
        <source>no valid motor among the samples</source>
        <translation>kein gültiger Motor unter den Stichproben</translation>
    </message>
    <message>
        <source>a relay experiment needs a level, a period and an oscillation larger than its hysteresis</source>
        <translation>ein Relaisversuch braucht eine Höhe, eine Periode und eine Schwingung, die größer als seine Hysterese ist</translation>
    </message>
    <message>
        <source>this process does not oscillate under proportional control: no ultimate gain</source>
        <translation>dieser Prozess schwingt unter P-Regelung nicht: keine kritische Verstärkung</translation>
    </message>
    <message>
        <source>weight every state that does not decay by itself</source>
        <translation>jeden Zustand gewichten, der nicht von selbst abklingt</translation>
    </message>
    <message>
        <source>allow a larger Ms, or reduce the computing delay</source>
        <translation>größeres Ms zulassen, oder die Rechentotzeit verringern</translation>
    </message>
    <message>
        <source>use a slower target, or reduce the computing delay</source>
        <translation>langsameres Ziel verwenden, oder die Rechentotzeit verringern</translation>
    </message>
    <message>
        <source>invalid design targets: they must be positive, Ms above 1</source>
        <translation>ungültige Entwurfsziele: Sie müssen positiv sein, Ms über 1</translation>
    </message>
    <message>
        <source>invalid filter: {} is out of range</source>
        <translation>ungültiges Filter: {} liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>this sampled system does not correspond to a continuous one</source>
        <translation>dieses Abtastsystem entspricht keinem kontinuierlichen System</translation>
    </message>
    <message>
        <source>Use a shorter distance, or set {} on the device. Nothing was armed.</source>
        <translation>Kürzeren Weg verwenden, oder {} im Gerät setzen. Nichts wurde freigegeben.</translation>
    </message>
    <message>
        <source>Use a longer move. Check the gains and that the axis is free.</source>
        <translation>Längere Bewegung verwenden. Reglerparameter prüfen und ob die Achse frei ist.</translation>
    </message>
    <message>
        <source>Use a longer move. Check the gains and that the rotor is free.</source>
        <translation>Längere Bewegung verwenden. Reglerparameter prüfen und ob der Rotor frei ist.</translation>
    </message>
    <message>
        <source>Check that no other program uses the device, then move again.</source>
        <translation>Prüfen, dass kein anderes Programm das Gerät verwendet, dann erneut bewegen.</translation>
    </message>
    <message>
        <source>Check the rotor position and that no other program uses the device, then move again.</source>
        <translation>Rotorposition prüfen und dass kein anderes Programm das Gerät verwendet, dann erneut bewegen.</translation>
    </message>
    <message>
        <source>check the position of the actuator, then start again; newer firmware tolerates a lost answer</source>
        <translation>Position des Aktors prüfen, dann neu starten; neuere Firmware verträgt eine verlorene Antwort</translation>
    </message>
    <message>
        <source>{}; ended, because its start was not confirmed</source>
        <translation>{}; beendet, weil der Start nicht bestätigt wurde</translation>
    </message>
    <message>
        <source>the device sent more than requested</source>
        <translation>das Gerät sendete mehr als angefordert</translation>
    </message>
    <message>
        <source>{}: the kernel driver &apos;{}&apos; cannot be detached: {}</source>
        <translation>{}: der Kerneltreiber &apos;{}&apos; lässt sich nicht lösen: {}</translation>
    </message>
    <message>
        <source>to use it as device, connect to {}: the driver is detached until you disconnect</source>
        <translation>um es als Gerät zu verwenden, mit {} verbinden: Der Treiber wird bis zum Trennen gelöst</translation>
    </message>
    <message>
        <source>use another port, or start the computer without &apos;console=&apos; for this one</source>
        <translation>einen anderen Port verwenden, oder den Computer ohne &apos;console=&apos; für diesen starten</translation>
    </message>
    <message>
        <source>the computer was too busy or in standby: connect again, with fewer signals or a lower rate</source>
        <translation>der Computer war zu beschäftigt oder im Ruhezustand: neu verbinden, mit weniger Signalen oder kleinerer Rate</translation>
    </message>
    <message>
        <source>{} MB from the device were not processed in time</source>
        <translation>{} MB vom Gerät wurden nicht rechtzeitig verarbeitet</translation>
    </message>
    <message>
        <source>identify this device and use its model for tuning</source>
        <translation>dieses Gerät identifizieren und sein Modell für die Auslegung verwenden</translation>
    </message>
    <message>
        <source>Rejected: this loop is unstable</source>
        <translation>Abgelehnt: Dieser Kreis ist instabil</translation>
    </message>
    <message>
        <source>Doubtful: read the warnings before applying</source>
        <translation>Zweifelhaft: vor dem Übernehmen die Warnungen lesen</translation>
    </message>
    <message>
        <source>Stable under the stated assumptions:</source>
        <translation>Stabil unter den genannten Annahmen:</translation>
    </message>
    <message>
        <source>{} rows lost: disk too slow</source>
        <translation>{} Zeilen verloren: Datenträger zu langsam</translation>
    </message>
    <message>
        <source>with dead time the gain of this loop must fall below 1 at high frequency</source>
        <translation>mit Totzeit muss die Verstärkung dieses Kreises bei hoher Frequenz unter 1 fallen</translation>
    </message>
    <message>
        <source>change the gain slightly</source>
        <translation>Verstärkung leicht ändern</translation>
    </message>
    <message>
        <source>the Nyquist curve passes through -1: the loop is at the stability limit</source>
        <translation>die Nyquist-Kurve geht durch -1: Der Kreis ist an der Stabilitätsgrenze</translation>
    </message>
    <message>
        <source>the device reports neither its firmware nor the identification in its description: it is unknown whether they match</source>
        <translation>das Gerät meldet weder seine Firmware noch die Kennung seiner Beschreibung: Ob sie zusammenpassen, ist unbekannt</translation>
    </message>
    <message>
        <source>at most {} can be read; write parts with --from and --to</source>
        <translation>höchstens {} sind lesbar; Teile mit --from und --to schreiben</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;: incomplete</source>
        <translation>&apos;{}&apos; nicht schreibbar: unvollständig</translation>
    </message>
    <message>
        <source>end the other connection, then connect again; an inactive connection ends after a few seconds</source>
        <translation>die andere Verbindung beenden, dann neu verbinden; eine inaktive Verbindung endet nach einigen Sekunden</translation>
    </message>
    <message>
        <source>{}: another program is connected to this device</source>
        <translation>{}: ein anderes Programm ist mit diesem Gerät verbunden</translation>
    </message>
    <message>
        <source>use the description of this firmware, or update the firmware completely</source>
        <translation>die Beschreibung dieser Firmware verwenden, oder die Firmware vollständig aktualisieren</translation>
    </message>
    <message>
        <source>writing is blocked: the description does not match the firmware of the device</source>
        <translation>Schreiben ist gesperrt: Die Beschreibung passt nicht zur Firmware des Geräts</translation>
    </message>
    <message>
        <source>firmware &apos;{}&apos; does not match the description of &apos;{}&apos;: writing is blocked; use the description of this firmware, or update the firmware completely</source>
        <translation>Firmware &apos;{}&apos; passt nicht zur Beschreibung von &apos;{}&apos;: Schreiben ist gesperrt; die Beschreibung dieser Firmware verwenden, oder die Firmware vollständig aktualisieren</translation>
    </message>
    <message>
        <source>its length does not match {} rows</source>
        <translation>seine Länge passt nicht zu {} Zeilen</translation>
    </message>
    <message>
        <source>its time channel or link is invalid</source>
        <translation>sein Zeitkanal oder Verweis ist ungültig</translation>
    </message>
    <message>
        <source>its row length does not match its channels</source>
        <translation>seine Zeilenlänge passt nicht zu seinen Kanälen</translation>
    </message>
    <message>
        <source>not a valid signal name</source>
        <translation>kein gültiger Signalname</translation>
    </message>
    <message>
        <source>only MDF4 files of Halbench can be read; export CSV in that program</source>
        <translation>nur MDF4-Dateien von Halbench sind lesbar; in jenem Programm CSV exportieren</translation>
    </message>
    <message>
        <source>the file is from another program</source>
        <translation>die Datei stammt von einem anderen Programm</translation>
    </message>
    <message>
        <source>writing was interrupted; write it again</source>
        <translation>das Schreiben wurde unterbrochen; neu schreiben</translation>
    </message>
    <message>
        <source>the file must begin with &quot;MDF&quot;</source>
        <translation>die Datei muss mit &quot;MDF&quot; beginnen</translation>
    </message>
    <message>
        <source>not an MDF file</source>
        <translation>keine MDF-Datei</translation>
    </message>
    <message>
        <source>unexpected links</source>
        <translation>unerwartete Verweise</translation>
    </message>
    <message>
        <source>invalid length {}</source>
        <translation>ungültige Länge {}</translation>
    </message>
    <message>
        <source>unexpected block type</source>
        <translation>unerwarteter Blocktyp</translation>
    </message>
    <message>
        <source>it is outside the file</source>
        <translation>er liegt außerhalb der Datei</translation>
    </message>
    <message>
        <source>{}: block {} at byte {}: {}</source>
        <translation>{}: Block {} bei Byte {}: {}</translation>
    </message>
    <message>
        <source>the file is damaged or from another program; export CSV there</source>
        <translation>die Datei ist beschädigt oder von einem anderen Programm; dort CSV exportieren</translation>
    </message>
    <message>
        <source>reduce the overlap, or use a part of the recording</source>
        <translation>Überlappung verringern, oder einen Teil der Aufzeichnung verwenden</translation>
    </message>
    <message>
        <source>{} segments of {} lines exceed the size of a spectrogram</source>
        <translation>{} Abschnitte mit {} Linien überschreiten die Größe eines Spektrogramms</translation>
    </message>
    <message>
        <source>use a shorter segment, or a part of the recording with constant rate</source>
        <translation>kürzeren Abschnitt verwenden, oder einen Teil der Aufzeichnung mit konstanter Rate</translation>
    </message>
    <message>
        <source>the rate is not constant: {} rows from {} s on take {} s, average {} s</source>
        <translation>die Rate ist nicht konstant: {} Zeilen ab {} s dauern {} s, im Mittel {} s</translation>
    </message>
    <message>
        <source>a segment of {} s is too long: the longest part without gap or missing value has {} rows, {} s</source>
        <translation>ein Abschnitt von {} s ist zu lang: Der längste Teil ohne Lücke oder fehlenden Wert hat {} Zeilen, {} s</translation>
    </message>
    <message>
        <source>record for longer, or at a rate without losses</source>
        <translation>länger oder mit einer Rate ohne Verluste aufzeichnen</translation>
    </message>
    <message>
        <source>fewer than {} consecutive rows without gap or missing value</source>
        <translation>weniger als {} aufeinanderfolgende Zeilen ohne Lücke oder fehlenden Wert</translation>
    </message>
    <message>
        <source>use a recording with more rows</source>
        <translation>eine Aufzeichnung mit mehr Zeilen verwenden</translation>
    </message>
    <message>
        <source>{} rows are too few for a sample rate</source>
        <translation>{} Zeilen sind zu wenige für eine Abtastrate</translation>
    </message>
    <message>
        <source>a spectrum needs a constant sample rate; resample the signal first</source>
        <translation>ein Spektrum braucht eine konstante Abtastrate; das Signal zuerst neu abtasten</translation>
    </message>
    <message>
        <source>uneven sampling: {} s before row {}, usually {} s</source>
        <translation>ungleichmäßige Abtastung: {} s vor Zeile {}, sonst {} s</translation>
    </message>
    <message>
        <source>sort the rows by time</source>
        <translation>Zeilen nach der Zeit sortieren</translation>
    </message>
    <message>
        <source>time does not increase from row {} to row {}</source>
        <translation>Zeit nimmt von Zeile {} zu Zeile {} nicht zu</translation>
    </message>
    <message>
        <source>this device does not report whether it stopped: use the stop switch at the actuator</source>
        <translation>dieses Gerät meldet nicht, ob es gestoppt hat: Stoppschalter am Aktor verwenden</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; was skipped: {}</source>
        <translation>Parameter &apos;{}&apos; übersprungen: {}</translation>
    </message>
    <message>
        <source>the parameters of &apos;{}&apos; are read-only: the active page of the device cannot be written</source>
        <translation>die Parameter von &apos;{}&apos; sind nur lesbar: Die aktive Seite des Geräts ist nicht beschreibbar</translation>
    </message>
    <message>
        <source>{}: addresses accept no option except a2l</source>
        <translation>{}:-Adressen erlauben keine Option außer a2l</translation>
    </message>
    <message>
        <source>the description &apos;{}&apos; has {} bytes</source>
        <translation>die Beschreibung &apos;{}&apos; hat {} Bytes</translation>
    </message>
    <message>
        <source>give the A2L file for the device&apos;s firmware</source>
        <translation>A2L-Datei für die Firmware des Geräts angeben</translation>
    </message>
    <message>
        <source>give the port of the device first, e.g. tcp:HOST:PORT</source>
        <translation>zuerst den Port des Geräts angeben, z. B. tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>device &apos;{}&apos; has a built-in description and does not use a file</source>
        <translation>Gerät &apos;{}&apos; hat eine eingebaute Beschreibung und verwendet keine Datei</translation>
    </message>
    <message>
        <source>recommended for this motor</source>
        <translation>empfohlen für diesen Motor</translation>
    </message>
    <message>
        <source>check the rows again, then restore</source>
        <translation>Zeilen erneut prüfen, dann wiederherstellen</translation>
    </message>
    <message>
        <source>the device changed before writing started</source>
        <translation>das Gerät änderte sich vor Beginn des Schreibens</translation>
    </message>
    <message>
        <source>plug it in to any port</source>
        <translation>an beliebigem Port anstecken</translation>
    </message>
    <message>
        <source>signals and parameters may differ: disconnect, then connect again</source>
        <translation>Signale und Parameter können abweichen: trennen, dann neu verbinden</translation>
    </message>
    <message>
        <source>{} reconnected with other firmware: {} instead of {}</source>
        <translation>{} mit anderer Firmware wieder verbunden: {} statt {}</translation>
    </message>
    <message>
        <source>plug in the previous device, or disconnect and connect this one</source>
        <translation>das vorige Gerät anstecken, oder trennen und dieses verbinden</translation>
    </message>
    <message>
        <source>check for another program or a loose connector, then connect again</source>
        <translation>auf ein anderes Programm oder einen losen Stecker prüfen, dann neu verbinden</translation>
    </message>
    <message>
        <source>{} reconnected and was lost again {} times in a row</source>
        <translation>{} wurde {}-mal nacheinander verbunden und wieder verloren</translation>
    </message>
    <message>
        <source>{} plateaus were not steady at their end and were excluded</source>
        <translation>{} Plateaus waren am Ende nicht stationär und wurden ausgeschlossen</translation>
    </message>
    <message>
        <source>one plateau was not steady at its end and was excluded</source>
        <translation>ein Plateau war am Ende nicht stationär und wurde ausgeschlossen</translation>
    </message>
    <message>
        <source>{} plateaus were too slow to distinguish friction from creep and were excluded</source>
        <translation>{} Plateaus waren zu langsam, um Reibung von Kriechen zu unterscheiden, und wurden ausgeschlossen</translation>
    </message>
    <message>
        <source>one plateau was too slow to distinguish friction from creep and was excluded</source>
        <translation>ein Plateau war zu langsam, um Reibung von Kriechen zu unterscheiden, und wurde ausgeschlossen</translation>
    </message>
    <message>
        <source>one plateau came to rest and was excluded</source>
        <translation>ein Plateau kam zum Stillstand und wurde ausgeschlossen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; occurs twice</source>
        <translation>&apos;{}&apos; kommt doppelt vor</translation>
    </message>
    <message>
        <source>&apos;device.{}&apos; is not allowed here</source>
        <translation>&apos;device.{}&apos; ist hier nicht erlaubt</translation>
    </message>
    <message>
        <source>nothing was written; correct this line or use another file</source>
        <translation>nichts wurde geschrieben; diese Zeile berichtigen oder eine andere Datei verwenden</translation>
    </message>
    <message>
        <source>the value read back differs</source>
        <translation>der zurückgelesene Wert weicht ab</translation>
    </message>
    <message>
        <source>nothing was written; disarm first</source>
        <translation>nichts wurde geschrieben; zuerst sperren</translation>
    </message>
    <message>
        <source>a configuration cannot be restored while the actuator is armed</source>
        <translation>bei freigegebenem Aktor lässt sich keine Konfiguration wiederherstellen</translation>
    </message>
    <message>
        <source>nothing was written; leave it out</source>
        <translation>nichts wurde geschrieben; weglassen</translation>
    </message>
    <message>
        <source>nothing was written; choose one of its rows</source>
        <translation>nichts wurde geschrieben; eine ihrer Zeilen wählen</translation>
    </message>
    <message>
        <source>check each row: a value may have another meaning in this firmware</source>
        <translation>jede Zeile prüfen: Ein Wert kann in dieser Firmware eine andere Bedeutung haben</translation>
    </message>
    <message>
        <source>its calibration was measured on that device and is excluded unless selected</source>
        <translation>ihre Kalibrierung wurde an jenem Gerät gemessen und ist ausgeschlossen, wenn nicht gewählt</translation>
    </message>
    <message>
        <source>record again with the description of this firmware</source>
        <translation>mit der Beschreibung dieser Firmware neu aufzeichnen</translation>
    </message>
    <message>
        <source>check whether the device was reset; the recording has a gap here</source>
        <translation>prüfen, ob das Gerät zurückgesetzt wurde; die Aufzeichnung hat hier eine Lücke</translation>
    </message>
    <message>
        <source>the device clock restarted: the time before this row is unknown</source>
        <translation>die Geräteuhr startete neu: Die Zeit vor dieser Zeile ist unbekannt</translation>
    </message>
    <message>
        <source>use a lower start frequency, more periods or a larger amplitude</source>
        <translation>niedrigere Startfrequenz, mehr Perioden oder größere Amplitude verwenden</translation>
    </message>
    <message>
        <source>damping undetermined: between zero and {} % of the torque at the lowest frequency</source>
        <translation>Dämpfung unbestimmt: zwischen null und {} % des Drehmoments bei der niedrigsten Frequenz</translation>
    </message>
    <message>
        <source>parameter {} of the device may still be {} instead of {} ms, as before arming: {}</source>
        <translation>Parameter {} des Geräts ist vielleicht noch {} statt {} ms, wie vor dem Freigeben: {}</translation>
    </message>
    <message>
        <source>not available on this device</source>
        <translation>in diesem Gerät nicht vorhanden</translation>
    </message>
    <message>
        <source>unit &apos;{}&apos; in the file, &apos;{}&apos; on the device</source>
        <translation>Einheit &apos;{}&apos; in der Datei, &apos;{}&apos; im Gerät</translation>
    </message>
    <message>
        <source>this value is a command or read-only on the device</source>
        <translation>dieser Wert ist im Gerät ein Befehl oder nur lesbar</translation>
    </message>
    <message>
        <source>nothing was written; use a file for this model</source>
        <translation>nichts wurde geschrieben; eine Datei für dieses Modell verwenden</translation>
    </message>
    <message>
        <source>the configuration is for a device of model &apos;{}&apos;, this device is of model &apos;{}&apos;</source>
        <translation>die Konfiguration ist für ein Gerät des Modells &apos;{}&apos;, dieses Gerät ist vom Modell &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the firmware of &apos;{}&apos; changed from &apos;{}&apos; to &apos;{}&apos;; the description was read again</source>
        <translation>die Firmware von &apos;{}&apos; wechselte von &apos;{}&apos; zu &apos;{}&apos;; die Beschreibung wurde neu gelesen</translation>
    </message>
    <message>
        <source>connect again; if the error remains, update the firmware</source>
        <translation>neu verbinden; bleibt der Fehler, Firmware aktualisieren</translation>
    </message>
    <message>
        <source>the device&apos;s description ends after {} bytes</source>
        <translation>die Beschreibung des Geräts endet nach {} Bytes</translation>
    </message>
    <message>
        <source>check device and address; on a serial line also baud rate and framing</source>
        <translation>Gerät und Adresse prüfen; bei serieller Verbindung auch Baudrate und Rahmenformat</translation>
    </message>
    <message>
        <source>check address and port: another program uses this port</source>
        <translation>Adresse und Port prüfen: Ein anderes Programm verwendet diesen Port</translation>
    </message>
    <message>
        <source>{}: {}; not the expected protocol</source>
        <translation>{}: {}; nicht das erwartete Protokoll</translation>
    </message>
    <message>
        <source>{} % of the rows of the recording are missing</source>
        <translation>{} % der Zeilen der Aufzeichnung fehlen</translation>
    </message>
    <message>
        <source>give the share of messages, e.g. 0.01 for 1 %</source>
        <translation>Anteil der Nachrichten angeben, z. B. 0.01 für 1 %</translation>
    </message>
    <message>
        <source>connect again and compare the parameters before arming</source>
        <translation>neu verbinden und vor dem Freigeben die Parameter vergleichen</translation>
    </message>
    <message>
        <source>{}; restoring the previous values is not confirmed: {}</source>
        <translation>{}; das Wiederherstellen der vorigen Werte ist nicht bestätigt: {}</translation>
    </message>
    <message>
        <source>check the cause of the stop, then try again</source>
        <translation>Ursache des Stopps prüfen, dann erneut versuchen</translation>
    </message>
    <message>
        <source>interrupted by a stop; not executed</source>
        <translation>durch einen Stopp unterbrochen; nicht ausgeführt</translation>
    </message>
    <message>
        <source>{}: the device accepts no more commands</source>
        <translation>{}: das Gerät nimmt keine Befehle mehr an</translation>
    </message>
    <message>
        <source>{}: the device halted its endpoint</source>
        <translation>{}: das Gerät hat seinen Endpunkt angehalten</translation>
    </message>
    <message>
        <source>use {} or {}</source>
        <translation>{} oder {} verwenden</translation>
    </message>
    <message>
        <source>plug it in; &apos;halbench devices&apos; lists the addresses</source>
        <translation>anstecken; &apos;halbench devices&apos; listet die Adressen</translation>
    </message>
    <message>
        <source>plug in the correct device, or use {}</source>
        <translation>das richtige Gerät anstecken, oder {} verwenden</translation>
    </message>
    <message>
        <source>{}: the connected device has the serial number &apos;{}&apos;</source>
        <translation>{}: das angeschlossene Gerät hat die Seriennummer &apos;{}&apos;</translation>
    </message>
    <message>
        <source>close it there; if it is not open, remove {}</source>
        <translation>dort schließen; falls nicht geöffnet, {} entfernen</translation>
    </message>
    <message>
        <source>remove the cause, then release the stop again</source>
        <translation>Ursache beseitigen, dann den Stopp erneut aufheben</translation>
    </message>
    <message>
        <source>interrupted by a stop</source>
        <translation>durch einen Stopp unterbrochen</translation>
    </message>
    <message>
        <source>a stop was sent before the device answered</source>
        <translation>ein Stopp wurde gesendet, bevor das Gerät antwortete</translation>
    </message>
    <message>
        <source>{}: connection attempt ended</source>
        <translation>{}: Verbindungsversuch beendet</translation>
    </message>
    <message>
        <source>{} sends data ({} bytes), but not in this protocol</source>
        <translation>{} sendet Daten ({} Bytes), aber nicht in diesem Protokoll</translation>
    </message>
    <message>
        <source>serial:{}: the device accepts no more commands</source>
        <translation>serial:{}: das Gerät nimmt keine Befehle mehr an</translation>
    </message>
    <message>
        <source>use 115200 or a rate supported by the adapter</source>
        <translation>115200 oder eine vom Adapter unterstützte Rate verwenden</translation>
    </message>
    <message>
        <source>{} does not support {} baud</source>
        <translation>{} unterstützt {} Baud nicht</translation>
    </message>
    <message>
        <source>give a serial port; &apos;halbench devices&apos; lists them</source>
        <translation>einen seriellen Port angeben; &apos;halbench devices&apos; listet sie</translation>
    </message>
    <message>
        <source>check the cable and that the device is on</source>
        <translation>Kabel prüfen und ob das Gerät eingeschaltet ist</translation>
    </message>
    <message>
        <source>plug the device in; &apos;halbench devices&apos; lists the addresses</source>
        <translation>Gerät anstecken; &apos;halbench devices&apos; listet die Adressen</translation>
    </message>
    <message>
        <source>{} not found</source>
        <translation>{} nicht gefunden</translation>
    </message>
    <message>
        <source>close that program (ModemManager releases a new port after some seconds)</source>
        <translation>dieses Programm schließen (ModemManager gibt einen neuen Port nach einigen Sekunden frei)</translation>
    </message>
    <message>
        <source>disconnect there first</source>
        <translation>zuerst dort trennen</translation>
    </message>
    <message>
        <source>install the rules printed by &apos;halbench devices --udev-rules&apos;, then plug the device in again</source>
        <translation>die von &apos;halbench devices --udev-rules&apos; ausgegebenen Regeln installieren, dann das Gerät neu anstecken</translation>
    </message>
    <message>
        <source>use two different bytes</source>
        <translation>zwei verschiedene Bytes verwenden</translation>
    </message>
    <message>
        <source>give one byte in hexadecimal digits, e.g. 9A</source>
        <translation>ein Byte in Hexadezimalziffern angeben, z. B. 9A</translation>
    </message>
    <message>
        <source>old gains restored</source>
        <translation>alte Reglerparameter wiederhergestellt</translation>
    </message>
    <message>
        <source>cancelled by the user</source>
        <translation>vom Benutzer abgebrochen</translation>
    </message>
    <message>
        <source>{} % of the motors within the model&apos;s uncertainty are unstable with this loop</source>
        <translation>{} % der Motoren innerhalb der Modellunsicherheit sind mit diesem Kreis instabil</translation>
    </message>
    <message>
        <source>the model has no covariance: robustness assumes an exactly known motor</source>
        <translation>das Modell hat keine Kovarianz: Die Robustheit setzt einen genau bekannten Motor voraus</translation>
    </message>
    <message>
        <source>the motor&apos;s damping exceeds the target: K_D is zero</source>
        <translation>die Dämpfung des Motors übertrifft das Ziel: K_D ist null</translation>
    </message>
    <message>
        <source>use method designed for these gains</source>
        <translation>für diese Reglerparameter Methode designed verwenden</translation>
    </message>
    <message>
        <source>the targets of the source (zeta 0.06 at 15 rad/s) give {} A/rad and {} A/(rad s) on this motor, not the printed 10 and 0.1</source>
        <translation>die Ziele der Quelle (zeta 0.06 bei 15 rad/s) ergeben an diesem Motor {} A/rad und {} A/(rad s), nicht die gedruckten 10 und 0.1</translation>
    </message>
    <message>
        <source>Damaged values from the device or the link; no result.</source>
        <translation>Beschädigte Werte vom Gerät oder von der Verbindung; kein Ergebnis.</translation>
    </message>
    <message>
        <source>axis {} is linear, but the reference is an angle</source>
        <translation>Achse {} ist linear, aber die Führungsgröße ist ein Winkel</translation>
    </message>
    <message>
        <source>axis {} is rotary, but the reference is a length</source>
        <translation>Achse {} ist rotatorisch, aber die Führungsgröße ist eine Länge</translation>
    </message>
    <message>
        <source>{} does not fit the other keys: a length with an angle</source>
        <translation>{} passt nicht zu den anderen Schlüsseln: eine Länge mit einem Winkel</translation>
    </message>
    <message>
        <source>the device has no axis zero and cannot find it</source>
        <translation>das Gerät hat keinen Achsennullpunkt und findet ihn nicht</translation>
    </message>
    <message>
        <source>waiting for standstill</source>
        <translation>wartet auf Stillstand</translation>
    </message>
    <message>
        <source>the device followed another reference than commanded, deviation {}</source>
        <translation>das Gerät folgte einer anderen Führungsgröße als vorgegeben, Abweichung {}</translation>
    </message>
    <message>
        <source>the device did not start its reference</source>
        <translation>das Gerät startete seine Führungsgröße nicht</translation>
    </message>
    <message>
        <source>the response contains a value that is not a number</source>
        <translation>die Antwort enthält einen Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>the response has too few samples to evaluate</source>
        <translation>die Antwort hat zu wenige Messwerte für die Auswertung</translation>
    </message>
    <message>
        <source>the covariance contains &apos;{}&apos;, for which the model has no value</source>
        <translation>die Kovarianz enthält &apos;{}&apos;, wofür das Modell keinen Wert hat</translation>
    </message>
    <message>
        <source>{} is missing in the model; it determines the loop</source>
        <translation>{} fehlt im Modell; es bestimmt den Kreis</translation>
    </message>
    <message>
        <source>use currents well above the breakaway current for several seconds each</source>
        <translation>Ströme deutlich über dem Losbrechstrom für jeweils mehrere Sekunden verwenden</translation>
    </message>
    <message>
        <source>only the torque constant is used</source>
        <translation>nur die Drehmomentkonstante wird verwendet</translation>
    </message>
    <message>
        <source>the damping gives another inertia ({} standard errors): the added part changed the friction</source>
        <translation>die Dämpfung ergibt ein anderes Trägheitsmoment ({} Standardfehler): Das zusätzliche Teil hat die Reibung verändert</translation>
    </message>
    <message>
        <source>both runs must determine c/J, K_f/J and phi/J with covariance, without given constants</source>
        <translation>beide Läufe müssen c/J, K_f/J und phi/J mit Kovarianz bestimmen, ohne angegebene Konstanten</translation>
    </message>
    <message>
        <source>add transients (run-up and coast-down), or another given constant</source>
        <translation>Übergänge (Hoch- und Auslauf) oder eine weitere bekannte Konstante ergänzen</translation>
    </message>
    <message>
        <source>data and given constants do not determine all four constants</source>
        <translation>Daten und angegebene Konstanten bestimmen nicht alle vier Konstanten</translation>
    </message>
    <message>
        <source>angle and current determine only ratios of the constants</source>
        <translation>Winkel und Strom bestimmen nur Verhältnisse der Konstanten</translation>
    </message>
    <message>
        <source>omitting one plateau shifts the steady line by {} standard errors</source>
        <translation>Weglassen eines Plateaus verschiebt die stationäre Gerade um {} Standardfehler</translation>
    </message>
    <message>
        <source>friction may depend on speed; check the residuals</source>
        <translation>die Reibung hängt vielleicht von der Drehzahl ab; Residuen prüfen</translation>
    </message>
    <message>
        <source>friction may depend on speed; use only the relevant speed range</source>
        <translation>die Reibung hängt vielleicht von der Drehzahl ab; nur den relevanten Drehzahlbereich verwenden</translation>
    </message>
    <message>
        <source>steady speed is not linear in the current (lack of fit, p = {})</source>
        <translation>die stationäre Drehzahl ist nicht linear im Strom (mangelnde Anpassung, p = {})</translation>
    </message>
    <message>
        <source>check the plateaus of low weight; repeat the sweep</source>
        <translation>Plateaus mit kleinem Gewicht prüfen; Messreihe wiederholen</translation>
    </message>
    <message>
        <source>torque changes with speed more than current lag explains: commutation angle or stray-field compensation is wrong</source>
        <translation>das Drehmoment ändert sich mit der Drehzahl mehr, als die Stromverzögerung erklärt: Kommutierungswinkel oder Streufeldkompensation ist falsch</translation>
    </message>
    <message>
        <source>friction may depend on speed: the intervals do not include this error; use higher currents only</source>
        <translation>die Reibung hängt vielleicht von der Drehzahl ab: Die Intervalle enthalten diesen Fehler nicht; nur größere Ströme verwenden</translation>
    </message>
    <message>
        <source>model inadequate: the residual of one segment is {} times larger than usual</source>
        <translation>Modell unzureichend: Das Residuum eines Abschnitts ist {}-mal größer als üblich</translation>
    </message>
    <message>
        <source>use a longer time at each current</source>
        <translation>bei jedem Strom länger verweilen</translation>
    </message>
    <message>
        <source>{} plateaus came to rest and were excluded</source>
        <translation>{} Plateaus kamen zum Stillstand und wurden ausgeschlossen</translation>
    </message>
    <message>
        <source>the curvature of the motion is too small to determine c/J</source>
        <translation>die Krümmung der Bewegung ist zu klein, um c/J zu bestimmen</translation>
    </message>
    <message>
        <source>the recording has {} rows per second, less than 100</source>
        <translation>die Aufzeichnung hat {} Zeilen je Sekunde, weniger als 100</translation>
    </message>
    <message>
        <source>required columns: time_s, position_rad and current_command_A; present: {}</source>
        <translation>nötige Spalten: time_s, position_rad und current_command_A; vorhanden: {}</translation>
    </message>
    <message>
        <source>signals position or current_command missing in the recording</source>
        <translation>Signale position oder current_command fehlen in der Aufzeichnung</translation>
    </message>
    <message>
        <source>record at least several seconds of motion</source>
        <translation>mindestens mehrere Sekunden Bewegung aufzeichnen</translation>
    </message>
    <message>
        <source>the recording has too few rows</source>
        <translation>die Aufzeichnung hat zu wenige Zeilen</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a constant of the motor</source>
        <translation>&apos;{}&apos; ist keine Konstante des Motors</translation>
    </message>
    <message>
        <source>Nothing was armed. Use a shorter run or less current, or let the motor cool.</source>
        <translation>Nichts wurde freigegeben. Kürzeren Lauf oder weniger Strom verwenden, oder den Motor abkühlen lassen.</translation>
    </message>
    <message>
        <source>expected coil temperature {} degC, limit {} degC</source>
        <translation>erwartete Spulentemperatur {} degC, Grenzwert {} degC</translation>
    </message>
    <message>
        <source>cooling the coils: {} degC</source>
        <translation>Spulen kühlen ab: {} degC</translation>
    </message>
    <message>
        <source>Cool the motor, then try again.</source>
        <translation>Motor kühlen, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>coil temperature {} degC, does not fall below {} degC</source>
        <translation>Spulentemperatur {} degC, sinkt nicht unter {} degC</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a trigger</source>
        <translation>&apos;{}&apos; ist kein Trigger</translation>
    </message>
    <message>
        <source>Damaged values from the device or the link; nothing was saved.</source>
        <translation>Beschädigte Werte vom Gerät oder von der Verbindung; nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>the device captured other signals than requested</source>
        <translation>das Gerät erfasste andere Signale als angefordert</translation>
    </message>
    <message>
        <source>waiting for the trigger</source>
        <translation>wartet auf den Trigger</translation>
    </message>
    <message>
        <source>use a higher current</source>
        <translation>größeren Strom verwenden</translation>
    </message>
    <message>
        <source>the rotor broke away in too few ramps</source>
        <translation>der Rotor brach bei zu wenigen Rampen los</translation>
    </message>
    <message>
        <source>current ramp from rest</source>
        <translation>Stromrampe aus dem Stillstand</translation>
    </message>
    <message>
        <source>d-axis current at standstill</source>
        <translation>D-Achsen-Strom im Stillstand</translation>
    </message>
    <message>
        <source>turning to the next angle</source>
        <translation>dreht zum nächsten Winkel</translation>
    </message>
    <message>
        <source>no calibration selected</source>
        <translation>keine Kalibrierung gewählt</translation>
    </message>
    <message>
        <source>turning fast (angle error)</source>
        <translation>dreht schnell (Winkelfehler)</translation>
    </message>
    <message>
        <source>the rotor did not turn fast and long enough to measure the residual angle error of the ellipse</source>
        <translation>der Rotor drehte nicht schnell und lange genug, um den Restwinkelfehler der Ellipse zu messen</translation>
    </message>
    <message>
        <source>use the ellipse without the map</source>
        <translation>Ellipse ohne Korrekturtabelle verwenden</translation>
    </message>
    <message>
        <source>the residual angle error of the ellipse, {} degrees rms, is too uncertain ({} degrees from speed ripple and scatter)</source>
        <translation>der Restwinkelfehler der Ellipse, {} Grad (Effektivwert), ist zu unsicher ({} Grad aus Drehzahlwelligkeit und Streuung)</translation>
    </message>
    <message>
        <source>use a rotation current above the breakaway current</source>
        <translation>Drehstrom über dem Losbrechstrom verwenden</translation>
    </message>
    <message>
        <source>turning slowly (Hall sensors)</source>
        <translation>dreht langsam (Hall-Sensoren)</translation>
    </message>
    <message>
        <source>check for saturated sensors or a loose magnet</source>
        <translation>auf übersteuerte Sensoren oder losen Magneten prüfen</translation>
    </message>
    <message>
        <source>distance of the readings from the ellipse: {} % of the amplitude</source>
        <translation>Abstand der Messwerte von der Ellipse: {} % der Amplitude</translation>
    </message>
    <message>
        <source>Old values restored. Identify the motor again, or use lower gains.</source>
        <translation>Alte Werte wiederhergestellt. Motor neu identifizieren oder kleinere Reglerparameter verwenden.</translation>
    </message>
    <message>
        <source>{}: {} {}, limit of the prediction {} {}</source>
        <translation>{}: {} {}, Grenze der Vorhersage {} {}</translation>
    </message>
    <message>
        <source>no prediction available for a {}</source>
        <translation>keine Vorhersage für {} verfügbar</translation>
    </message>
    <message>
        <source>Old values restored. Check the device limits.</source>
        <translation>Alte Werte wiederhergestellt. Gerätegrenzwerte prüfen.</translation>
    </message>
    <message>
        <source>use a ramp for large moves, or a slower loop</source>
        <translation>für große Bewegungen eine Rampe verwenden, oder einen langsameren Kreis</translation>
    </message>
    <message>
        <source>steps above {} deg reach the current limit of {} A; with limit and friction a step of {} deg overshoots by {} %</source>
        <translation>Sprünge über {} deg erreichen die Stromgrenze von {} A; mit Grenze und Reibung schwingt ein Sprung von {} deg um {} % über</translation>
    </message>
    <message>
        <source>error of the stray coefficient {} %, this gain requires less than {} %</source>
        <translation>Fehler des Streukoeffizienten {} %, diese Verstärkung erfordert weniger als {} %</translation>
    </message>
    <message>
        <source>this gain requires a stray coefficient known to better than {} %; its error is unknown</source>
        <translation>diese Verstärkung erfordert einen auf besser als {} % bekannten Streukoeffizienten; sein Fehler ist unbekannt</translation>
    </message>
    <message>
        <source>the stray field of the coils is not compensated and couples the current into the angle: with this gain the loop can alternate every sample</source>
        <translation>das Streufeld der Spulen ist nicht kompensiert und koppelt den Strom in den Winkel ein: Mit dieser Verstärkung kann der Kreis von Abtastung zu Abtastung wechseln</translation>
    </message>
    <message>
        <source>only the integral action removes the standstill error, slowly; the micro-step assist or a larger K_P narrows the band</source>
        <translation>nur der I-Anteil beseitigt den Stillstandsfehler, langsam; Mikroschritthilfe oder größeres K_P verkleinern das Band</translation>
    </message>
    <message>
        <source>usual minimum: 30 deg and factor 2</source>
        <translation>übliches Minimum: 30 deg und Faktor 2</translation>
    </message>
    <message>
        <source>small margins: phase {} deg, gain factor {}</source>
        <translation>kleine Reserven: Phase {} deg, Verstärkungsfaktor {}</translation>
    </message>
    <message>
        <source>a PI loop has little damping on this motor; add derivative action: method recommended</source>
        <translation>ein PI-Kreis hat an diesem Motor wenig Dämpfung; D-Anteil ergänzen: Methode recommended</translation>
    </message>
    <message>
        <source>the loop is nearly undamped (zeta = {} at {} rad/s): damping is by friction only</source>
        <translation>der Kreis ist fast ungedämpft (zeta = {} bei {} rad/s): Nur die Reibung dämpft</translation>
    </message>
    <message>
        <source>the rotor makes at best small steps; large steps end in a limit cycle</source>
        <translation>der Rotor macht bestenfalls kleine Sprünge; große Sprünge enden in einer Dauerschwingung</translation>
    </message>
    <message>
        <source>only friction and the current limit bound the motion; stable above {} times these gains: increase them, or use method recommended</source>
        <translation>nur Reibung und Stromgrenze begrenzen die Bewegung; stabil oberhalb des {}-Fachen dieser Reglerparameter: sie erhöhen, oder Methode recommended verwenden</translation>
    </message>
    <message>
        <source>only friction and the current limit bound the motion; stable below {} times these gains: reduce K_P, or use method recommended</source>
        <translation>nur Reibung und Stromgrenze begrenzen die Bewegung; stabil unterhalb des {}-Fachen dieser Reglerparameter: K_P verringern, oder Methode recommended verwenden</translation>
    </message>
    <message>
        <source>only friction and the current limit bound the motion, and no common factor on these gains gives stability: change their ratio or the filters, or use method recommended</source>
        <translation>nur Reibung und Stromgrenze begrenzen die Bewegung, und kein gemeinsamer Faktor auf diese Reglerparameter ergibt Stabilität: ihr Verhältnis oder die Filter ändern, oder Methode recommended verwenden</translation>
    </message>
    <message>
        <source>K_P = {}, K_I = {}, K_D = {} is not a valid position loop</source>
        <translation>K_P = {}, K_I = {}, K_D = {} ist kein gültiger Lageregelkreis</translation>
    </message>
    <message>
        <source>no picture to save</source>
        <translation>kein Bild zum Speichern</translation>
    </message>
    <message>
        <source>open it with the newer version, or install that version</source>
        <translation>mit der neueren Version öffnen, oder diese installieren</translation>
    </message>
    <message>
        <source>{}: is a &apos;{}&apos; of a newer version</source>
        <translation>{}: ist ein &apos;{}&apos; einer neueren Version</translation>
    </message>
    <message>
        <source>the file is not changed; open another project or correct this line</source>
        <translation>die Datei bleibt unverändert; ein anderes Projekt öffnen oder diese Zeile berichtigen</translation>
    </message>
    <message>
        <source>check its findings, then identify again</source>
        <translation>Befunde prüfen, dann neu identifizieren</translation>
    </message>
    <message>
        <source>{}: this estimate was rejected</source>
        <translation>{}: diese Schätzung wurde abgelehnt</translation>
    </message>
    <message>
        <source>report this with the command line used</source>
        <translation>dies mit der verwendeten Befehlszeile melden</translation>
    </message>
    <message>
        <source>a coil of {} mm width leaves no winding window within half a pitch of {} mm</source>
        <translation>eine Spule von {} mm Breite lässt kein Wickelfenster in der halben Teilung von {} mm</translation>
    </message>
    <message>
        <source>The direction of the jump is unknown. Check the sensors or turn more slowly.</source>
        <translation>Die Richtung des Sprungs ist unbekannt. Sensoren prüfen oder langsamer drehen.</translation>
    </message>
    <message>
        <source>the device&apos;s description has {} bytes</source>
        <translation>die Beschreibung des Geräts hat {} Bytes</translation>
    </message>
    <message>
        <source>the device has no built-in description</source>
        <translation>das Gerät hat keine eingebaute Beschreibung</translation>
    </message>
    <message>
        <source>{} stopped responding</source>
        <translation>{} antwortet nicht mehr</translation>
    </message>
    <message>
        <source>make sure that no other program uses the device, then connect again</source>
        <translation>sicherstellen, dass kein anderes Programm das Gerät verwendet, dann neu verbinden</translation>
    </message>
    <message>
        <source>{} ended the session (watchdog timeout, or another program connected)</source>
        <translation>{} beendete die Sitzung (Watchdog abgelaufen, oder ein anderes Programm verband sich)</translation>
    </message>
    <message>
        <source>the device rejected {}: {}</source>
        <translation>das Gerät wies {} ab: {}</translation>
    </message>
    <message>
        <source>value of &apos;{}&apos; after writing: {} {} instead of {}</source>
        <translation>Wert von &apos;{}&apos; nach dem Schreiben: {} {} statt {}</translation>
    </message>
    <message>
        <source>this device cannot change a set at once: values change one by one</source>
        <translation>dieses Gerät kann keinen Satz auf einmal ändern: Werte ändern sich einzeln</translation>
    </message>
    <message>
        <source>the old values are kept; use values within the device limits</source>
        <translation>die alten Werte bleiben; Werte innerhalb der Gerätegrenzen verwenden</translation>
    </message>
    <message>
        <source>the value of &apos;{}&apos; read back differs from the one sent</source>
        <translation>der zurückgelesene Wert von &apos;{}&apos; weicht vom gesendeten ab</translation>
    </message>
    <message>
        <source>the device or another program ended the stream; connect again</source>
        <translation>das Gerät oder ein anderes Programm beendete den Datenstrom; neu verbinden</translation>
    </message>
    <message>
        <source>{} stopped sending samples</source>
        <translation>{} sendet keine Messwerte mehr</translation>
    </message>
    <message>
        <source>, the device clock is fast by {} +- {} ppm</source>
        <translation>, die Uhr des Geräts geht {} ± {} ppm vor</translation>
    </message>
    <message>
        <source>the device does not release its stop: {}</source>
        <translation>das Gerät hebt seinen Stopp nicht auf: {}</translation>
    </message>
    <message>
        <source>use the stop switch at the actuator and check the device</source>
        <translation>Stoppschalter am Aktor verwenden und das Gerät prüfen</translation>
    </message>
    <message>
        <source>the device does not {}</source>
        <translation>das Gerät führt {} nicht aus</translation>
    </message>
    <message>
        <source>remove the cause, then release the stop</source>
        <translation>Ursache beseitigen, dann den Stopp aufheben</translation>
    </message>
    <message>
        <source>use the manufacturer&apos;s program to arm it</source>
        <translation>zum Freigeben das Programm des Herstellers verwenden</translation>
    </message>
    <message>
        <source>this device has no &apos;{}&apos; and cannot be armed by this program</source>
        <translation>dieses Gerät hat kein &apos;{}&apos; und kann von diesem Programm nicht freigegeben werden</translation>
    </message>
    <message>
        <source>the description was not cached: {}</source>
        <translation>die Beschreibung wurde nicht zwischengespeichert: {}</translation>
    </message>
    <message>
        <source>description read from the device, {} bytes</source>
        <translation>Beschreibung aus dem Gerät gelesen, {} Bytes</translation>
    </message>
    <message>
        <source>stream only signals of the same event together</source>
        <translation>nur Signale desselben Ereignisses gemeinsam streamen</translation>
    </message>
    <message>
        <source>the device samples &apos;{}&apos; ({}) at another event than &apos;{}&apos; ({})</source>
        <translation>das Gerät tastet &apos;{}&apos; ({}) zu einem anderen Ereignis ab als &apos;{}&apos; ({})</translation>
    </message>
    <message>
        <source>the nearest possible rate: {} Hz</source>
        <translation>nächste mögliche Rate: {} Hz</translation>
    </message>
    <message>
        <source>the nearest possible rates: {} Hz and {} Hz</source>
        <translation>nächste mögliche Raten: {} Hz und {} Hz</translation>
    </message>
    <message>
        <source>the old values are kept; check the limits of the device</source>
        <translation>die alten Werte bleiben; Grenzwerte des Geräts prüfen</translation>
    </message>
    <message>
        <source>the values read back differ from those sent</source>
        <translation>die zurückgelesenen Werte weichen von den gesendeten ab</translation>
    </message>
    <message>
        <source>check the state of the device; the old values are kept</source>
        <translation>Zustand des Geräts prüfen; die alten Werte bleiben</translation>
    </message>
    <message>
        <source>the device did not accept the new parameter set</source>
        <translation>das Gerät hat den neuen Parametersatz nicht angenommen</translation>
    </message>
    <message>
        <source>check that the control loop is running; the old values are kept</source>
        <translation>prüfen, ob der Regelkreis läuft; die alten Werte bleiben</translation>
    </message>
    <message>
        <source>the device does not release its inactive parameter page</source>
        <translation>das Gerät gibt seine inaktive Parameterseite nicht frei</translation>
    </message>
    <message>
        <source>only pages 0 and 1 are supported; update the firmware</source>
        <translation>nur die Seiten 0 und 1 werden unterstützt; Firmware aktualisieren</translation>
    </message>
    <message>
        <source>the device uses page {} of a segment of {} bytes</source>
        <translation>das Gerät verwendet Seite {} eines Segments von {} Bytes</translation>
    </message>
    <message>
        <source>invalid sampling resolution ({})</source>
        <translation>ungültige Abtastauflösung ({})</translation>
    </message>
    <message>
        <source>the answer to GET_ID announces {} bytes and contains {}</source>
        <translation>die Antwort auf GET_ID kündigt {} Bytes an und enthält {}</translation>
    </message>
    <message>
        <source>the device does not use a supported protocol</source>
        <translation>das Gerät verwendet kein unterstütztes Protokoll</translation>
    </message>
    <message>
        <source>the device announces packets of {} and {} bytes, at least 8 are required</source>
        <translation>das Gerät meldet Pakete von {} und {} Bytes, mindestens 8 sind nötig</translation>
    </message>
    <message>
        <source>only byte granularity is supported</source>
        <translation>nur Byte-Granularität wird unterstützt</translation>
    </message>
    <message>
        <source>the device counts addresses in words, not bytes</source>
        <translation>das Gerät zählt Adressen in Wörtern, nicht in Bytes</translation>
    </message>
    <message>
        <source>the answer to {} has {} bytes ({}), {} are required</source>
        <translation>die Antwort auf {} hat {} Bytes ({}), {} sind nötig</translation>
    </message>
    <message>
        <source>the device rejects the command</source>
        <translation>das Gerät weist den Befehl ab</translation>
    </message>
    <message>
        <source>free disk space or make the folder writable</source>
        <translation>Speicherplatz freigeben oder den Ordner beschreibbar machen</translation>
    </message>
    <message>
        <source>use fewer signals</source>
        <translation>weniger Signale verwenden</translation>
    </message>
    <message>
        <source>{} signals do not fit into one sample of this device</source>
        <translation>{} Signale passen nicht in einen Messwertsatz dieses Geräts</translation>
    </message>
    <message>
        <source>signal {} has {} bytes; the device samples values of up to {} bytes in steps of {}</source>
        <translation>Signal {} hat {} Bytes; das Gerät tastet Werte bis {} Bytes in Schritten von {} ab</translation>
    </message>
    <message>
        <source>this device has no capture function</source>
        <translation>dieses Gerät hat keine Erfassungsfunktion</translation>
    </message>
    <message>
        <source>&apos;{}&apos; (byte {} of the description): {}</source>
        <translation>&apos;{}&apos; (Byte {} der Beschreibung): {}</translation>
    </message>
    <message>
        <source>its type &apos;{}&apos; is unknown</source>
        <translation>sein Typ &apos;{}&apos; ist unbekannt</translation>
    </message>
    <message>
        <source>found /end {} where /end {} is expected</source>
        <translation>/end {} statt des erwarteten /end {}</translation>
    </message>
    <message>
        <source>description of the device, byte {}: {}</source>
        <translation>Beschreibung des Geräts, Byte {}: {}</translation>
    </message>
    <message>
        <source>{} bytes exceed the allowed {}</source>
        <translation>{} Bytes überschreiten die erlaubten {}</translation>
    </message>
    <message>
        <source>the device closed the connection (possibly taken over by another program)</source>
        <translation>das Gerät schloss die Verbindung (möglicherweise von einem anderen Programm übernommen)</translation>
    </message>
    <message>
        <source>the device accepts no more commands</source>
        <translation>das Gerät nimmt keine Befehle mehr an</translation>
    </message>
    <message>
        <source>check that the device is on and not used by another program, then connect again</source>
        <translation>prüfen, ob das Gerät eingeschaltet und nicht von einem anderen Programm belegt ist, dann neu verbinden</translation>
    </message>
    <message>
        <source>check that the device is on and the address is correct</source>
        <translation>prüfen, ob das Gerät eingeschaltet und die Adresse richtig ist</translation>
    </message>
    <message>
        <source>the other side does not use this protocol</source>
        <translation>die Gegenstelle verwendet dieses Protokoll nicht</translation>
    </message>
    <message>
        <source>message length {} bytes, allowed are 1 to {}</source>
        <translation>Nachrichtenlänge {} Bytes, erlaubt sind 1 bis {}</translation>
    </message>
    <message>
        <source>give each key only once</source>
        <translation>jeden Schlüssel nur einmal angeben</translation>
    </message>
    <message>
        <source>use a shorter time</source>
        <translation>kürzere Zeit verwenden</translation>
    </message>
    <message>
        <source>use a rate that divides {} Hz</source>
        <translation>eine Rate verwenden, die {} Hz teilt</translation>
    </message>
    <message>
        <source>the recording of {} Hz cannot be replayed at {} Hz</source>
        <translation>die Aufzeichnung mit {} Hz kann nicht mit {} Hz wiedergegeben werden</translation>
    </message>
    <message>
        <source>connect a real or simulated device</source>
        <translation>ein echtes oder simuliertes Gerät verbinden</translation>
    </message>
    <message>
        <source>this is a recording: it cannot be changed, armed or stopped</source>
        <translation>dies ist eine Aufzeichnung: Sie kann nicht verändert, freigegeben oder gestoppt werden</translation>
    </message>
    <message>
        <source>wait until it is finished, or use another name</source>
        <translation>warten, bis es fertig ist, oder einen anderen Namen verwenden</translation>
    </message>
    <message>
        <source>remove the .meta.json file to read the data without it</source>
        <translation>.meta.json-Datei entfernen, um die Daten ohne sie zu lesen</translation>
    </message>
    <message>
        <source>{}: byte {}: {}</source>
        <translation>{}: Byte {}: {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no complete row</source>
        <translation>&apos;{}&apos; hat keine vollständige Zeile</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has {} bytes</source>
        <translation>&apos;{}&apos; hat {} Bytes</translation>
    </message>
    <message>
        <source>write numbers like -1.5e-3, with a decimal point</source>
        <translation>Zahlen wie -1.5e-3 schreiben, mit Dezimalpunkt</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; occurs twice</source>
        <translation>Spalte &apos;{}&apos; kommt doppelt vor</translation>
    </message>
    <message>
        <source>its range is {} s to {} s</source>
        <translation>ihr Bereich ist {} s bis {} s</translation>
    </message>
    <message>
        <source>it has no rows</source>
        <translation>sie hat keine Zeilen</translation>
    </message>
    <message>
        <source>available: {}</source>
        <translation>verfügbar: {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has a format that cannot be written</source>
        <translation>&apos;{}&apos; hat ein Format, das nicht geschrieben werden kann</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has a format that cannot be read</source>
        <translation>&apos;{}&apos; hat ein Format, das nicht gelesen werden kann</translation>
    </message>
    <message>
        <source>use a longer excitation, a wider band or fewer lines</source>
        <translation>längere Anregung, breiteres Band oder weniger Linien verwenden</translation>
    </message>
    <message>
        <source>{} to {} Hz cannot contain {} lines {} Hz apart</source>
        <translation>{} bis {} Hz können keine {} Linien im Abstand {} Hz enthalten</translation>
    </message>
    <message>
        <source>an algebraic loop: one of the two systems needs a delay</source>
        <translation>algebraische Schleife: Eines der beiden Systeme braucht eine Totzeit</translation>
    </message>
    <message>
        <source>add the filter or actuator of the real system</source>
        <translation>Filter oder Stellglied des realen Systems hinzufügen</translation>
    </message>
    <message>
        <source>{} rad/s is outside the frequency range of the system</source>
        <translation>{} rad/s liegt außerhalb des Frequenzbereichs des Systems</translation>
    </message>
    <message>
        <source>the records do not separate torque, friction and damping</source>
        <translation>die Aufzeichnungen trennen Drehmoment, Reibung und Dämpfung nicht</translation>
    </message>
    <message>
        <source>record run-ups or coast-downs</source>
        <translation>Hoch- oder Ausläufe aufzeichnen</translation>
    </message>
    <message>
        <source>record at a higher rate or for a longer time</source>
        <translation>mit höherer Rate oder länger aufzeichnen</translation>
    </message>
    <message>
        <source>the fit depends on single points</source>
        <translation>die Anpassung hängt von einzelnen Punkten ab</translation>
    </message>
    <message>
        <source>check the recording for faults</source>
        <translation>Aufzeichnung auf Fehler prüfen</translation>
    </message>
    <message>
        <source>use a longer plateau time</source>
        <translation>längere Plateauzeit verwenden</translation>
    </message>
    <message>
        <source>sort the rows and remove duplicates</source>
        <translation>Zeilen sortieren und Duplikate entfernen</translation>
    </message>
    <message>
        <source>the recording contains a value that is not a number</source>
        <translation>die Aufzeichnung enthält einen Wert, der keine Zahl ist</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs besides steady motion</source>
        <translation>zusätzlich zur stetigen Bewegung Hoch- und Ausläufe aufzeichnen</translation>
    </message>
    <message>
        <source>the segments have no curvature: damping undetermined</source>
        <translation>die Abschnitte haben keine Krümmung: Dämpfung unbestimmt</translation>
    </message>
    <message>
        <source>the damping cannot be determined from the motion</source>
        <translation>die Dämpfung ist aus der Bewegung nicht bestimmbar</translation>
    </message>
    <message>
        <source>remove the damaged rows</source>
        <translation>beschädigte Zeilen entfernen</translation>
    </message>
    <message>
        <source>record at a higher rate</source>
        <translation>mit höherer Rate aufzeichnen</translation>
    </message>
    <message>
        <source>a segment of the motion has too few samples</source>
        <translation>ein Bewegungsabschnitt hat zu wenige Messwerte</translation>
    </message>
    <message>
        <source>the recording has no motion under constant current</source>
        <translation>die Aufzeichnung enthält keine Bewegung unter konstantem Strom</translation>
    </message>
    <message>
        <source>use more different currents, speeds or directions</source>
        <translation>mehr verschiedene Ströme, Drehzahlen oder Richtungen verwenden</translation>
    </message>
    <message>
        <source>the points do not separate the coefficients</source>
        <translation>die Punkte trennen die Koeffizienten nicht</translation>
    </message>
    <message>
        <source>{} usable points cannot determine {} coefficients</source>
        <translation>{} brauchbare Punkte können {} Koeffizienten nicht bestimmen</translation>
    </message>
    <message>
        <source>check the recording for gaps or faults</source>
        <translation>Aufzeichnung auf Lücken oder Fehler prüfen</translation>
    </message>
    <message>
        <source>the speed does not increase with the current</source>
        <translation>die Drehzahl nimmt nicht mit dem Strom zu</translation>
    </message>
    <message>
        <source>use at least three currents in one direction, or four in both</source>
        <translation>mindestens drei Ströme in einer Richtung oder vier in beiden verwenden</translation>
    </message>
    <message>
        <source>too few plateaus to estimate the scatter</source>
        <translation>zu wenige Plateaus, um die Streuung zu schätzen</translation>
    </message>
    <message>
        <source>exclude plateaus that come to rest from the fit</source>
        <translation>Plateaus mit Stillstand von der Anpassung ausschließen</translation>
    </message>
    <message>
        <source>at one plateau the rotor stands still or turns against the current</source>
        <translation>bei einem Plateau steht der Rotor oder dreht gegen den Strom</translation>
    </message>
    <message>
        <source>parts of the recording do not cover a full turn</source>
        <translation>Teile der Aufzeichnung decken keine volle Umdrehung ab</translation>
    </message>
    <message>
        <source>turn the rotor by several full turns</source>
        <translation>Rotor um mehrere volle Umdrehungen drehen</translation>
    </message>
    <message>
        <source>use a higher current, from rest</source>
        <translation>größeren Strom verwenden, aus dem Stillstand</translation>
    </message>
    <message>
        <source>the rotor did not break away during the ramp</source>
        <translation>der Rotor brach während der Rampe nicht los</translation>
    </message>
    <message>
        <source>record from the start of the ramp</source>
        <translation>ab Beginn der Rampe aufzeichnen</translation>
    </message>
    <message>
        <source>step it with both signs</source>
        <translation>in beiden Vorzeichen springen lassen</translation>
    </message>
    <message>
        <source>use a higher speed before the coast-down, or add a second current</source>
        <translation>höhere Drehzahl vor dem Auslauf verwenden, oder einen zweiten Strom ergänzen</translation>
    </message>
    <message>
        <source>all usable motion is at one current (coast-downs missing or too short): torque and friction cannot be separated</source>
        <translation>alle brauchbare Bewegung liegt bei einem Strom (Ausläufe fehlen oder sind zu kurz): Drehmoment und Reibung nicht trennbar</translation>
    </message>
    <message>
        <source>repeat some currents</source>
        <translation>einige Ströme wiederholen</translation>
    </message>
    <message>
        <source>no repeated points to check the model</source>
        <translation>keine Wiederholungspunkte zur Prüfung des Modells</translation>
    </message>
    <message>
        <source>fix a larger known inertia to the rotor, about equal to the rotor&apos;s own; the first run must be without it</source>
        <translation>ein größeres bekanntes Trägheitsmoment am Rotor befestigen, etwa so groß wie das des Rotors; der erste Lauf muss ohne es sein</translation>
    </message>
    <message>
        <source>the added inertia is not significant compared with the errors of both runs</source>
        <translation>das zusätzliche Trägheitsmoment ist gegenüber den Fehlern beider Läufe nicht signifikant</translation>
    </message>
    <message>
        <source>the covariance of the model is not valid</source>
        <translation>die Kovarianz des Modells ist ungültig</translation>
    </message>
    <message>
        <source>phi/J = {}, c/J = {}, K_f/phi = {} is not a valid motor: torque per ampere must be positive, damping and friction not negative</source>
        <translation>phi/J = {}, c/J = {}, K_f/phi = {} ist kein gültiger Motor: Drehmoment je Ampere muss positiv sein, Dämpfung und Reibung nicht negativ</translation>
    </message>
    <message>
        <source>use the parallel or the standard form</source>
        <translation>parallele oder Standardform verwenden</translation>
    </message>
    <message>
        <source>use the parallel form</source>
        <translation>parallele Form verwenden</translation>
    </message>
    <message>
        <source>without proportional gain the time-constant forms do not exist</source>
        <translation>ohne Proportionalverstärkung existieren die Formen mit Zeitkonstanten nicht</translation>
    </message>
    <message>
        <source>without integral action the integral time is infinite</source>
        <translation>ohne Integralanteil ist die Nachstellzeit unendlich</translation>
    </message>
    <message>
        <source>an integral time of zero means an infinite integral gain</source>
        <translation>eine Nachstellzeit von null bedeutet eine unendliche Integralverstärkung</translation>
    </message>
    <message>
        <source>the step response of this unstable loop overflows</source>
        <translation>die Sprungantwort dieses instabilen Kreises läuft über</translation>
    </message>
    <message>
        <source>printed numbers read per degree; large steps end in a limit cycle</source>
        <translation>gedruckte Zahlen je Grad gelesen; große Sprünge enden in einer Dauerschwingung</translation>
    </message>
    <message>
        <source>zeta = 0.06 at 15 rad/s, as intended by the source</source>
        <translation>zeta = 0.06 bei 15 rad/s, wie von der Quelle beabsichtigt</translation>
    </message>
    <message>
        <source>stiffest loop with the requested phase margin</source>
        <translation>steifster Kreis mit der gewünschten Phasenreserve</translation>
    </message>
    <message>
        <source>recommended shape with the requested closed-loop bandwidth</source>
        <translation>empfohlene Form mit der gewünschten Bandbreite des geschlossenen Kreises</translation>
    </message>
    <message>
        <source>PI with the requested dominant pole pair, as far as the motor&apos;s damping allows</source>
        <translation>PI mit dem gewünschten dominanten Polpaar, soweit die Dämpfung des Motors es zulässt</translation>
    </message>
    <message>
        <source>use 30 to 60 deg, or omit the crossover</source>
        <translation>30 bis 60 deg verwenden, oder die Durchtrittsfrequenz weglassen</translation>
    </message>
    <message>
        <source>zeta = {} at {} rad/s cannot be reached with a PI position loop on this motor: zeta &lt;= c/(2 J omega) = {}</source>
        <translation>zeta = {} bei {} rad/s ist mit einem PI-Lageregler an diesem Motor nicht erreichbar: zeta &lt;= c/(2 J omega) = {}</translation>
    </message>
    <message>
        <source>the step height is zero</source>
        <translation>die Sprunghöhe ist null</translation>
    </message>
    <message>
        <source>the step response contains a value that is not finite</source>
        <translation>die Sprungantwort enthält einen Wert, der nicht endlich ist</translation>
    </message>
    <message>
        <source>the values of a model depend on each other: identify again with --given, e.g. &apos;halbench identify FILE.csv --given J=5.5e-4 --out&apos;</source>
        <translation>die Werte eines Modells hängen voneinander ab: mit --given neu identifizieren, z. B. &apos;halbench identify FILE.csv --given J=5.5e-4 --out&apos;</translation>
    </message>
    <message>
        <source>unit of column &apos;{}&apos; in &apos;{}&apos;: missing, {} is assumed</source>
        <translation>Einheit der Spalte &apos;{}&apos; in &apos;{}&apos;: fehlt, {} angenommen</translation>
    </message>
    <message>
        <source>correct the unit, or remove the .meta.json file to read the data without it</source>
        <translation>Einheit berichtigen, oder die .meta.json-Datei entfernen, um die Daten ohne sie zu lesen</translation>
    </message>
    <message>
        <source>name the column with its quantity, e.g. {}, or give the unit with halbench import --unit</source>
        <translation>Spalte nach ihrer Größe benennen, z. B. {}, oder die Einheit mit halbench import --unit angeben</translation>
    </message>
    <message>
        <source>deg is an angle unit; write degrees Celsius as degC</source>
        <translation>deg ist eine Winkeleinheit; Grad Celsius als degC schreiben</translation>
    </message>
    <message>
        <source>Use a longer recording, with the rotor moving and no channel clipped.</source>
        <translation>Längere Aufzeichnung verwenden, mit bewegtem Rotor und ohne übersteuerten Kanal.</translation>
    </message>
    <message>
        <source>Move it through the whole workspace, tilt and spin.</source>
        <translation>Durch den ganzen Arbeitsbereich bewegen: neigen und drehen.</translation>
    </message>
    <message>
        <source>The common scale of all gains is not observable separately from the strength q: their mean is set to one. A known field is required; the orientation is not affected.</source>
        <translation>Der gemeinsame Maßstab aller Verstärkungen ist nicht getrennt von der Stärke q beobachtbar: Ihr Mittel ist eins gesetzt. Ein bekanntes Feld ist nötig; die Orientierung ist nicht betroffen.</translation>
    </message>
    <message>
        <source>A common rotation of all sensors is not observable: the mean rotation is set to zero. A known orientation is required to determine it.</source>
        <translation>Eine gemeinsame Drehung aller Sensoren ist nicht beobachtbar: Die mittlere Drehung ist null gesetzt. Zur Bestimmung ist eine bekannte Orientierung nötig.</translation>
    </message>
    <message>
        <source>An additive device has no tensor condition.</source>
        <translation>Ein additives Gerät hat keine Tensorkondition.</translation>
    </message>
    <message>
        <source>The time does not increase in row {} of the table of poses.</source>
        <translation>In Zeile {} der Posentabelle nimmt die Zeit nicht zu.</translation>
    </message>
    <message>
        <source>procedure {} is not available for this device; nothing was armed</source>
        <translation>Ablauf {} ist für dieses Gerät nicht verfügbar; nichts wurde freigegeben</translation>
    </message>
    <message>
        <source>use a procedure of this device: {}</source>
        <translation>einen Ablauf dieses Geräts verwenden: {}</translation>
    </message>
    <message>
        <source>{}; choose one with --axis, in an experiment with the key &apos;axis&apos;</source>
        <translation>{}; eine mit --axis wählen, in einem Experiment mit dem Schlüssel &apos;axis&apos;</translation>
    </message>
    <message>
        <source>{}; move one axis at a time</source>
        <translation>{}; eine Achse nach der anderen bewegen</translation>
    </message>
    <message>
        <source>write both ends around the value, or null</source>
        <translation>beide Grenzen um den Wert schreiben, oder null</translation>
    </message>
    <message>
        <source>must be in ascending order, {} is more than {}</source>
        <translation>muss aufsteigend sein, {} ist größer als {}</translation>
    </message>
    <message>
        <source>must contain the value: {} is not in {} ... {}</source>
        <translation>muss den Wert enthalten: {} liegt nicht in {} ... {}</translation>
    </message>
    <message>
        <source>is {}, not possible for a motor</source>
        <translation>ist {}, für einen Motor nicht möglich</translation>
    </message>
    <message>
        <source>check the signs of current and angle in the recording, then identify again</source>
        <translation>Vorzeichen von Strom und Winkel in der Aufzeichnung prüfen, dann neu identifizieren</translation>
    </message>
    <message>
        <source>reaches from {} to {}: whether it is above zero is unknown</source>
        <translation>reicht von {} bis {}: Ob der Wert über null liegt, ist unbekannt</translation>
    </message>
    <message>
        <source>lower end of the interval of c/J: {} 1/s</source>
        <translation>untere Grenze des Intervalls von c/J: {} 1/s</translation>
    </message>
    <message>
        <source>no finding gives the cause</source>
        <translation>kein Befund nennt die Ursache</translation>
    </message>
    <message>
        <source>the model used for the assessment is doubtful: {}</source>
        <translation>das für die Beurteilung verwendete Modell ist zweifelhaft: {}</translation>
    </message>
    <message>
        <source>check the findings of the model, then identify again</source>
        <translation>Befunde des Modells prüfen, dann neu identifizieren</translation>
    </message>
    <message>
        <source>the calibration used for the assessment is doubtful: {}</source>
        <translation>die für die Beurteilung verwendete Kalibrierung ist zweifelhaft: {}</translation>
    </message>
    <message>
        <source>check the findings of the calibration, then calibrate again</source>
        <translation>Befunde der Kalibrierung prüfen, dann neu kalibrieren</translation>
    </message>
    <message>
        <source>the relay experiment for these gains is doubtful: {}</source>
        <translation>der Relaisversuch zu diesen Reglerparametern ist zweifelhaft: {}</translation>
    </message>
    <message>
        <source>check the findings of the experiment, then measure again</source>
        <translation>Befunde des Versuchs prüfen, dann neu messen</translation>
    </message>
    <message>
        <source>this procedure needs a freely turning rotor; this device has axes with limited travel; nothing was armed</source>
        <translation>dieser Ablauf braucht einen frei drehenden Rotor; dieses Gerät hat Achsen mit begrenztem Weg; nichts wurde freigegeben</translation>
    </message>
    <message>
        <source>use the command line; it selects the procedure for the device</source>
        <translation>Kommandozeile verwenden; sie wählt den passenden Ablauf für das Gerät</translation>
    </message>
    <message>
        <source>{} % of the packets arrived out of order</source>
        <translation>{} % der Pakete kamen in falscher Reihenfolge an</translation>
    </message>
    <message>
        <source>connect by tcp: instead of udp:; tcp keeps the order</source>
        <translation>über tcp: statt udp: verbinden; tcp wahrt die Reihenfolge</translation>
    </message>
    <message>
        <source>{} % of the packets were lost, none was damaged</source>
        <translation>{} % der Pakete gingen verloren, keines war beschädigt</translation>
    </message>
    <message>
        <source>First line: time_s,alpha_deg,beta_deg,gamma_deg (or ..._rad); then numbers.</source>
        <translation>Erste Zeile: time_s,alpha_deg,beta_deg,gamma_deg (oder ..._rad); dann Zahlen.</translation>
    </message>
    <message>
        <source>{}: value {} is not a number</source>
        <translation>{}: Wert {} ist keine Zahl</translation>
    </message>
    <message>
        <source>{}: the time does not increase</source>
        <translation>{}: die Zeit nimmt nicht zu</translation>
    </message>
    <message>
        <source>{}: no poses after the first line</source>
        <translation>{}: keine Posen nach der ersten Zeile</translation>
    </message>
    <message>
        <source>friction may depend on speed, or torque is not proportional to the current</source>
        <translation>die Reibung hängt vielleicht von der Drehzahl ab, oder das Drehmoment ist nicht proportional zum Strom</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: above {} A forward the torque per ampere is {} % of that below</source>
        <translation>Drehmoment nicht proportional zum vorgegebenen Strom: Über {} A vorwärts ist das Drehmoment je Ampere {} % des Werts darunter</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: above {} A in reverse the torque per ampere is {} % of that below</source>
        <translation>Drehmoment nicht proportional zum vorgegebenen Strom: Über {} A rückwärts ist das Drehmoment je Ampere {} % des Werts darunter</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: above {} A the torque per ampere is {} % of that below</source>
        <translation>Drehmoment nicht proportional zum vorgegebenen Strom: Über {} A ist das Drehmoment je Ampere {} % des Werts darunter</translation>
    </message>
    <message>
        <source>measure the real current: the amplifier may saturate, have a dead zone or unequal gains; identify within its linear range</source>
        <translation>tatsächlichen Strom messen: Der Verstärker ist vielleicht gesättigt, hat eine Totzone oder ungleiche Verstärkungen; im linearen Bereich identifizieren</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: {} A less than commanded, compared with the coast-downs</source>
        <translation>Drehmoment nicht proportional zum vorgegebenen Strom: {} A weniger als vorgegeben, verglichen mit den Ausläufen</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: torque per ampere differs by {} % between the directions</source>
        <translation>Drehmoment nicht proportional zum vorgegebenen Strom: Das Drehmoment je Ampere unterscheidet sich um {} % zwischen den Richtungen</translation>
    </message>
    <message>
        <source>torque per ampere changed by {} % during the recording</source>
        <translation>das Drehmoment je Ampere hat sich während der Aufzeichnung um {} % geändert</translation>
    </message>
    <message>
        <source>let coils and magnets cool, check the supply, then record again</source>
        <translation>Spulen und Magnete abkühlen lassen, Versorgung prüfen, dann neu aufzeichnen</translation>
    </message>
    <message>
        <source>friction changed by {} % during the recording</source>
        <translation>die Reibung hat sich während der Aufzeichnung um {} % geändert</translation>
    </message>
    <message>
        <source>warm up the bearings, then record again</source>
        <translation>Lager warmlaufen lassen, dann neu aufzeichnen</translation>
    </message>
    <message>
        <source>friction increases with the current: driving and braking differ by more than friction</source>
        <translation>die Reibung nimmt mit dem Strom zu: Antreiben und Bremsen unterscheiden sich um mehr als die Reibung</translation>
    </message>
    <message>
        <source>the torque may load the bearings: the uncertainty of the torque constant is larger than stated</source>
        <translation>das Drehmoment belastet vielleicht die Lager: Die Unsicherheit der Drehmomentkonstante ist größer als angegeben</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: not a straight line (lack of fit, p = {})</source>
        <translation>Drehmoment nicht proportional zum vorgegebenen Strom: keine Gerade (mangelnde Anpassung, p = {})</translation>
    </message>
    <message>
        <source>torque residuals of the segments up to {} % of the largest torque: more than run-to-run friction scatter</source>
        <translation>Drehmomentresiduen der Abschnitte bis {} % des größten Drehmoments: mehr als die Reibungsstreuung zwischen den Läufen</translation>
    </message>
    <message>
        <source>move the rotor</source>
        <translation>bewegen Sie den Rotor</translation>
    </message>
    <message>
        <source>there are no rows</source>
        <translation>es gibt keine Zeilen</translation>
    </message>
    <message>
        <source>Cut the recording with halbench convert, or leave the reference columns out.</source>
        <translation>Schneiden Sie die Aufzeichnung mit halbench convert, oder lassen Sie die Referenzspalten weg.</translation>
    </message>
    <message>
        <source>the known orientation at {} s is not a number</source>
        <translation>die bekannte Orientierung bei {} s ist keine Zahl</translation>
    </message>
    <message>
        <source>Convert it with halbench import --unit COLUMN=mT.</source>
        <translation>Rechnen Sie um mit halbench import --unit COLUMN=mT.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; reads {} T: it is in another unit</source>
        <translation>'{}' liest {} T: Die Einheit ist eine andere</translation>
    </message>
    <message>
        <source>there is no signal &apos;{}&apos;</source>
        <translation>es gibt kein Signal '{}'</translation>
    </message>
    <message>
        <source>Switch the coil off, or change its current in the record.</source>
        <translation>Schalten Sie die Spule aus, oder ändern Sie ihren Strom während der Aufzeichnung.</translation>
    </message>
    <message>
        <source>{} A flow through the coil all the time: its field is taken for offsets</source>
        <translation>{} A fließen ständig durch die Spule: Ihr Feld gilt als Offset</translation>
    </message>
    <message>
        <source>Record with the coil&apos;s current switched between 0 and 1 A or more.</source>
        <translation>Zeichnen Sie auf, während der Spulenstrom zwischen 0 und 1 A oder mehr wechselt.</translation>
    </message>
    <message>
        <source>the coil&apos;s current changed by {} A only: its field keeps its value</source>
        <translation>der Strom der Spule änderte sich nur um {} A: Ihr Feld behält seinen Wert</translation>
    </message>
    <message>
        <source>Record while the magnet warms up by 2 K or more.</source>
        <translation>Zeichnen Sie auf, während sich der Magnet um 2 K oder mehr erwärmt.</translation>
    </message>
    <message>
        <source>the temperature changed by {} K only: the drift of the field keeps its value</source>
        <translation>die Temperatur änderte sich nur um {} K: Die Drift des Felds behält ihren Wert</translation>
    </message>
    <message>
        <source>Check for a stuck channel, a changing stray field or iron near the rotor.</source>
        <translation>Suchen Sie einen hängenden Kanal, ein wechselndes Streufeld oder Eisen beim Rotor.</translation>
    </message>
    <message>
        <source>the readings differ from the calibrated model by {} T rms</source>
        <translation>die Messwerte weichen um {} T effektiv vom kalibrierten Modell ab</translation>
    </message>
    <message>
        <source>Check the sensor; leave the channel out with channels.off and calibrate again.</source>
        <translation>Prüfen Sie den Sensor; lassen Sie den Kanal mit channels.off weg und kalibrieren Sie erneut.</translation>
    </message>
    <message>
        <source>{} comes out as {}: the channel is dead, stuck or wired wrongly</source>
        <translation>{} ergibt sich zu {}: Der Kanal ist tot, hängt oder ist falsch verdrahtet</translation>
    </message>
    <message>
        <source>choose hall, stray or all</source>
        <translation>wählen Sie hall, stray oder all</translation>
    </message>
    <message>
        <source>a device that only senses has no static friction to calibrate</source>
        <translation>ein Gerät, das nur misst, hat keine Haftreibung zu kalibrieren</translation>
    </message>
    <message>
        <source>the board followed another path than commanded, {} {} away</source>
        <translation>die Platine folgte einer anderen Bahn als befohlen, {} {} entfernt</translation>
    </message>
    <message>
        <source>Move for longer, or leave the duration out.</source>
        <translation>Länger bewegen oder die Dauer weglassen.</translation>
    </message>
    <message>
        <source>the {} takes {} s, the move ends after {} s</source>
        <translation>{} dauert {} s, die Bewegung endet nach {} s</translation>
    </message>
    <message>
        <source>Name no axis.</source>
        <translation>Keine Achse nennen.</translation>
    </message>
    <message>
        <source>a {} moves two axes</source>
        <translation>ein {} bewegt zwei Achsen</translation>
    </message>
    <message>
        <source>Move one axis: a step, a trapezoid, an s-curve.</source>
        <translation>Eine Achse bewegen: Sprung, Trapez, S-Kurve.</translation>
    </message>
    <message>
        <source>this device follows no path of two axes</source>
        <translation>dieses Gerät folgt keiner Bahn zweier Achsen</translation>
    </message>
    <message>
        <source>It has {}.</source>
        <translation>Er hat {}.</translation>
    </message>
    <message>
        <source>the generator of axis {} has no {}</source>
        <translation>der Generator der Achse {} hat kein {}</translation>
    </message>
    <message>
        <source>Leave base out.</source>
        <translation>base weglassen.</translation>
    </message>
    <message>
        <source>a {} has no constant motion</source>
        <translation>ein {} hat keine gleichförmige Bewegung</translation>
    </message>
    <message>
        <source>Give the whole reference in angles or in lengths.</source>
        <translation>Den ganzen Sollverlauf in Winkeln oder in Längen angeben.</translation>
    </message>
    <message>
        <source>, whole numbers</source>
        <translation>, ganze Zahlen</translation>
    </message>
    <message>
        <source>phases of a multisine; 0: those of least peak</source>
        <translation>Phasen eines Multisinus; 0: die mit der kleinsten Spitze</translation>
    </message>
    <message>
        <source>largest jerk of an S-curve or path</source>
        <translation>größter Ruck einer S-Kurve oder Bahn</translation>
    </message>
    <message>
        <source>the same of an axis that turns</source>
        <translation>dasselbe für eine Achse, die sich dreht</translation>
    </message>
    <message>
        <source>largest acceleration of a travel or path</source>
        <translation>größte Beschleunigung einer Fahrt oder Bahn</translation>
    </message>
    <message>
        <source>constant motion added</source>
        <translation>zusätzliche gleichförmige Bewegung</translation>
    </message>
    <message>
        <source>steps of a staircase, lines of a multisine</source>
        <translation>Stufen einer Treppe, Linien eines Multisinus</translation>
    </message>
    <message>
        <source>of a sine: 1/frequency; of a staircase: time of one step</source>
        <translation>eines Sinus: 1/Frequenz; einer Treppe: Dauer einer Stufe</translation>
    </message>
    <message>
        <source>the last one of chirp and multisine</source>
        <translation>die letzte von Chirp und Multisinus</translation>
    </message>
    <message>
        <source>of a sine; the first one of chirp and multisine</source>
        <translation>eines Sinus; die erste von Chirp und Multisinus</translation>
    </message>
    <message>
        <source>slope of a ramp, largest speed of a travel or path</source>
        <translation>Steigung einer Rampe, größte Geschwindigkeit einer Fahrt oder Bahn</translation>
    </message>
    <message>
        <source>the same in micrometres</source>
        <translation>dasselbe in Mikrometern</translation>
    </message>
    <message>
        <source>the same in millimetres</source>
        <translation>dasselbe in Millimetern</translation>
    </message>
    <message>
        <source>the same of an axis that moves along a line</source>
        <translation>dasselbe für eine Achse, die sich geradlinig bewegt</translation>
    </message>
    <message>
        <source>the same in microradians</source>
        <translation>dasselbe in Mikroradiant</translation>
    </message>
    <message>
        <source>the same in milliradians</source>
        <translation>dasselbe in Milliradiant</translation>
    </message>
    <message>
        <source>the same in radians</source>
        <translation>dasselbe in Radiant</translation>
    </message>
    <message>
        <source>height of the step or of one stair, amplitude of sine and chirp, rms of a multisine</source>
        <translation>Höhe des Sprungs oder einer Stufe, Amplitude von Sinus und Chirp, Effektivwert eines Multisinus</translation>
    </message>
    <message>
        <source>The old values run again. The mass, the inertia or the force constant is not the one of the model: identify the axes anew.</source>
        <translation>Die alten Werte laufen wieder. Masse, Trägheit oder Kraftkonstante sind nicht die des Modells: die Achsen neu identifizieren.</translation>
    </message>
    <message>
        <source>the motion took {} times the effort that the model needs for it, {} to {} are allowed</source>
        <translation>die Bewegung brauchte das {}-Fache der Stellgröße, die das Modell dafür braucht; erlaubt ist {} bis {}</translation>
    </message>
    <message>
        <source>Give a distance.</source>
        <translation>Eine Strecke angeben.</translation>
    </message>
    <message>
        <source>the distance of a travel is zero</source>
        <translation>die Strecke einer Fahrt ist null</translation>
    </message>
    <message>
        <source>Give a finite distance.</source>
        <translation>Eine endliche Strecke angeben.</translation>
    </message>
    <message>
        <source>the distance of a travel is not a number</source>
        <translation>die Strecke einer Fahrt ist keine Zahl</translation>
    </message>
    <message>
        <source>Give a limit above zero.</source>
        <translation>Eine Grenze über null angeben.</translation>
    </message>
    <message>
        <source>the largest {} of a travel is {}</source>
        <translation>der größte Wert von {} einer Fahrt ist {}</translation>
    </message>
    <message>
        <source>Give a finite limit.</source>
        <translation>Eine endliche Grenze angeben.</translation>
    </message>
    <message>
        <source>the largest {} of a travel is not a number</source>
        <translation>der größte Wert von {} einer Fahrt ist keine Zahl</translation>
    </message>
    <message>
        <source>Give at least one.</source>
        <translation>Mindestens eins angeben.</translation>
    </message>
    <message>
        <source>a path of {} {}</source>
        <translation>eine Bahn mit {} {}</translation>
    </message>
    <message>
        <source>Give the {}.</source>
        <translation>{} angeben.</translation>
    </message>
    <message>
        <source>the {} of a path is zero</source>
        <translation>{} einer Bahn ist null</translation>
    </message>
    <message>
        <source>Give a finite size.</source>
        <translation>Eine endliche Größe angeben.</translation>
    </message>
    <message>
        <source>the {} of a path is not a number</source>
        <translation>{} einer Bahn ist keine Zahl</translation>
    </message>
    <message>
        <source>this procedure needs a freely turning rotor and is not available for this device; nothing was armed</source>
        <translation>dieser Ablauf braucht einen frei drehenden Rotor und ist für dieses Gerät nicht verfügbar; nichts wurde freigegeben</translation>
    </message>
    <message>
        <source>A calibration needs positive deviations of readings, places and known orientations and at least one iteration.</source>
        <translation>Eine Kalibrierung braucht positive Abweichungen der Messwerte, Orte und bekannten Orientierungen und mindestens eine Iteration.</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Derivative gain on the measured position</source>
        <translation>Differentialverstärkung auf die gemessene Position</translation>
    </message>
    <message>
        <source>look at the residuals over current, time and angle, and measure the current that flows</source>
        <translation>sehen Sie sich die Residuen über Strom, Zeit und Winkel an, und messen Sie den Strom, der fließt</translation>
    </message>
    <message>
        <source>K_f/phi is {} A from plateaus and {} A from all motion (p = {})</source>
        <translation>K_f/phi ist {} A aus den Plateaus und {} A aus der ganzen Bewegung (p = {})</translation>
    </message>
    <message>
        <source>Spherical motor, orientation sensing</source>
        <translation>Kugelmotor, Lagemessung</translation>
    </message>
    <message>
        <source>True temperature of the magnet, known to the simulation only</source>
        <translation>Wahre Temperatur des Magneten, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True strength q of the field tensor, known to the simulation only</source>
        <translation>Wahre Stärke q des Feldtensors, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True rate about stator Z, known to the simulation only</source>
        <translation>Wahre Drehrate um Z des Stators, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True rate about stator Y, known to the simulation only</source>
        <translation>Wahre Drehrate um Y des Stators, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True rate about stator X, known to the simulation only</source>
        <translation>Wahre Drehrate um X des Stators, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True rotation about stator Z, first, known to the simulation only</source>
        <translation>Wahre Drehung um Z des Stators, als erste, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True rotation about stator Y, second, known to the simulation only</source>
        <translation>Wahre Drehung um Y des Stators, als zweite, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>True rotation about stator X, third, known to the simulation only</source>
        <translation>Wahre Drehung um X des Stators, als dritte, nur der Simulation bekannt</translation>
    </message>
    <message>
        <source>{}:1: not the columns of a motion</source>
        <translation>{}:1: nicht die Spalten einer Bewegung</translation>
    </message>
    <message>
        <source>cannot read the poses &apos;{}&apos;</source>
        <translation>Die Lagen „{}“ sind nicht lesbar</translation>
    </message>
    <message>
        <source>temperature coefficient</source>
        <translation>Temperaturkoeffizient</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>rotor</source>
        <translation>Rotor</translation>
    </message>
    <message>
        <source>Silence of the host that ends its session</source>
        <translation>Schweigen des Hosts, das seine Sitzung beendet</translation>
    </message>
    <message>
        <source>1, 2, 4 ...: channels to leave out, added</source>
        <translation>1, 2, 4 ...: auszulassende Kanäle, addiert</translation>
    </message>
    <message>
        <source>Subtract the coil&apos;s field</source>
        <translation>Feld der Spule abziehen</translation>
    </message>
    <message>
        <source>Chi-square that is flagged; 1e-9 of healthy readings exceed it</source>
        <translation>Chi-Quadrat, das gemeldet wird; 1e-9 der gesunden Messwerte liegen darüber</translation>
    </message>
    <message>
        <source>Share of the strength beyond which it is flagged</source>
        <translation>Anteil der Stärke, ab dem sie gemeldet wird</translation>
    </message>
    <message>
        <source>Temperature of the calibrated strength</source>
        <translation>Temperatur der kalibrierten Stärke</translation>
    </message>
    <message>
        <source>Relative change of the field with temperature</source>
        <translation>Relative Änderung des Feldes mit der Temperatur</translation>
    </message>
    <message>
        <source>Field of the stator coil at R, Theta, Phi of sensor 0, 1, 2</source>
        <translation>Feld der Statorspule in R, Theta, Phi an Sensor 0, 1, 2</translation>
    </message>
    <message>
        <source>Offset of R, Theta, Phi of sensor 0, 1, 2</source>
        <translation>Offset von R, Theta, Phi an Sensor 0, 1, 2</translation>
    </message>
    <message>
        <source>Cross-axis share R-Theta, R-Phi, Theta-Phi of sensor 0, 1, 2</source>
        <translation>Übersprechen R-Theta, R-Phi, Theta-Phi an Sensor 0, 1, 2</translation>
    </message>
    <message>
        <source>Gain error of R, Theta, Phi of sensor 0, 1, 2</source>
        <translation>Verstärkungsfehler von R, Theta, Phi an Sensor 0, 1, 2</translation>
    </message>
    <message>
        <source>Mounting error of sensor 0, 1, 2 about stator X, Y, Z</source>
        <translation>Einbaufehler von Sensor 0, 1, 2 um X, Y, Z des Stators</translation>
    </message>
    <message>
        <source>Order of the placement angles</source>
        <translation>Reihenfolge der Platzierungswinkel</translation>
    </message>
    <message>
        <source>Distance of the sensor from the centre</source>
        <translation>Abstand des Sensors vom Mittelpunkt</translation>
    </message>
    <message>
        <source>Placement of the sensor about stator Z</source>
        <translation>Platzierung des Sensors um Z des Stators</translation>
    </message>
    <message>
        <source>Placement of the sensor about stator Y</source>
        <translation>Platzierung des Sensors um Y des Stators</translation>
    </message>
    <message>
        <source>Placement of the sensor about stator X</source>
        <translation>Platzierung des Sensors um X des Stators</translation>
    </message>
    <message>
        <source>unrolled</source>
        <translation>ohne Rollen</translation>
    </message>
    <message>
        <source>Rx Ry Rz</source>
        <translation>Rx Ry Rz</translation>
    </message>
    <message>
        <source>Rz Ry Rx</source>
        <translation>Rz Ry Rx</translation>
    </message>
    <message>
        <source>of this sample</source>
        <translation>aus diesem Abtastwert</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>Whether these readings determined the orientation</source>
        <translation>Ob diese Messwerte die Lage bestimmt haben</translation>
    </message>
    <message>
        <source>1 channel left out, 2 held, 4 residual, 8 strength, 16 untested, added</source>
        <translation>1 Kanal ausgelassen, 2 gehalten, 4 Residuum, 8 Stärke, 16 ungeprüft, addiert</translation>
    </message>
    <message>
        <source>1, 2, 4 ...: channels that are not used, added</source>
        <translation>1, 2, 4 ...: nicht verwendete Kanäle, addiert</translation>
    </message>
    <message>
        <source>Temperature at the magnet</source>
        <translation>Temperatur am Magneten</translation>
    </message>
    <message>
        <source>Current of the stator coil</source>
        <translation>Strom der Statorspule</translation>
    </message>
    <message>
        <source>Residual along Phi of sensor {}</source>
        <translation>Residuum entlang Phi am Sensor {}</translation>
    </message>
    <message>
        <source>Residual along Theta of sensor {}</source>
        <translation>Residuum entlang Theta am Sensor {}</translation>
    </message>
    <message>
        <source>Residual along R of sensor {}</source>
        <translation>Residuum entlang R am Sensor {}</translation>
    </message>
    <message>
        <source>Field along Phi of sensor {}</source>
        <translation>Feld entlang Phi am Sensor {}</translation>
    </message>
    <message>
        <source>Field along Theta of sensor {}</source>
        <translation>Feld entlang Theta am Sensor {}</translation>
    </message>
    <message>
        <source>Field along R of sensor {}</source>
        <translation>Feld entlang R am Sensor {}</translation>
    </message>
    <message>
        <source>Squared residuals over the deviation, 4 on average when all is well</source>
        <translation>Quadrierte Residuen durch die Abweichung, im Mittel 4, wenn alles stimmt</translation>
    </message>
    <message>
        <source>The same by calibration and temperature</source>
        <translation>Dieselbe nach Kalibrierung und Temperatur</translation>
    </message>
    <message>
        <source>Strength q of the field tensor at 50 mm</source>
        <translation>Stärke q des Feldtensors bei 50 mm</translation>
    </message>
    <message>
        <source>Quaternion, Z</source>
        <translation>Quaternion, Z</translation>
    </message>
    <message>
        <source>Quaternion, Y</source>
        <translation>Quaternion, Y</translation>
    </message>
    <message>
        <source>Quaternion, X</source>
        <translation>Quaternion, X</translation>
    </message>
    <message>
        <source>Quaternion, real part</source>
        <translation>Quaternion, Realteil</translation>
    </message>
    <message>
        <source>Direction of the shaft, from X</source>
        <translation>Richtung der Welle, von X aus</translation>
    </message>
    <message>
        <source>Direction of the shaft, from Z</source>
        <translation>Richtung der Welle, von Z aus</translation>
    </message>
    <message>
        <source>Rotation about stator Z, first: the spin</source>
        <translation>Drehung um Z des Stators, als erste: die Eigendrehung</translation>
    </message>
    <message>
        <source>Rotation about stator Y, second</source>
        <translation>Drehung um Y des Stators, als zweite</translation>
    </message>
    <message>
        <source>Rotation about stator X, third</source>
        <translation>Drehung um X des Stators, als dritte</translation>
    </message>
    <message>
        <source>identify again with larger currents</source>
        <translation>mit größeren Strömen neu identifizieren</translation>
    </message>
    <message>
        <source>must be null or two finite numbers</source>
        <translation>muss null oder zwei endliche Zahlen sein</translation>
    </message>
    <message>
        <source>{}.ci95&quot; {}</source>
        <translation>{}.ci95&quot; {}</translation>
    </message>
    <message>
        <source>its axes are {}</source>
        <translation>seine Achsen sind {}</translation>
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
        <translation>Eine Anordnung braucht Sensoren außerhalb des Rotors, positive Stärke und positives Rauschen und mindestens einen Kandidaten der Endauswahl.</translation>
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
        <source>Record orientations that differ more in tilt and spin, or keep it at its nominal value.</source>
        <translation>Lagen aufzeichnen, die sich in Neigung und Drehung stärker unterscheiden, oder den Nennwert behalten.</translation>
    </message>
    <message>
        <source>The calibration was stopped.</source>
        <translation>Die Kalibrierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The rotor moved by only {} degrees in the recording.</source>
        <translation>Der Rotor bewegte sich in der Aufzeichnung nur um {} Grad.</translation>
    </message>
    <message>
        <source>Nothing is selected to be calibrated.</source>
        <translation>Zum Kalibrieren ist nichts ausgewählt.</translation>
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
        <translation>Kraft oder Drehmoment der Ströme entlang {}</translation>
    </message>
    <message>
        <source>Force or torque of the currents about the vertical</source>
        <translation>Kraft oder Drehmoment der Ströme um die Hochachse</translation>
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
        <translation>Quadrierte Residuen der Messwerte, bezogen auf ihre Streuung</translation>
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
        <translation>Größte Drehgeschwindigkeit, solange freigegeben</translation>
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
        <translation>Wahres Drehmoment der Spulen, nur der Simulation bekannt</translation>
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
        <source>unit of column &apos;{}&apos; in &apos;{}&apos;: deg is an angle; degrees Celsius are written degC</source>
        <translation>Einheit der Spalte „{}“ in „{}“: deg ist ein Winkel; Grad Celsius schreibt man degC</translation>
    </message>
    <message>
        <source>is {}, but the parameters say {}/{} = {}</source>
        <translation>ist {}, aber die Parameter sagen {}/{} = {}</translation>
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
        <translation>Sollwertgewichtung b des P-Anteils</translation>
    </message>
    <message>
        <source>Set-point weight c of the derivative part</source>
        <translation>Sollwertgewichtung c des D-Anteils</translation>
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
        <translation>Bei Verlust des Hosts gilt wieder diese Kalibrierung</translation>
    </message>
    <message>
        <source>Shape of the reference</source>
        <translation>Form der Führungsgröße</translation>
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
        <translation>durch Watchdog gestoppt</translation>
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
        <translation>Veröffentlichte Reglerparameter in Grad gelesen: 10 A/°, 0,1 A/(°·s)</translation>
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
        <source>give a value from {} to {}</source>
        <translation>geben Sie einen Wert von {} bis {} an</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; = {} is out of range</source>
        <translation>der Parameter „{}“ = {} ist außerhalb des Bereichs</translation>
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
        <source>10 A/rad and 0.1 A/(rad s), as printed</source>
        <translation>10 A/rad und 0,1 A/(rad s), wie gedruckt</translation>
    </message>
    <message>
        <source>5 A/deg and 0.05 A/(deg s), for steps of a few tenths of a degree</source>
        <translation>5 A/° und 0,05 A/(°·s), für Sprünge von einigen Zehntelgrad</translation>
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
        <source>the series form has real zeros only, these gains have complex ones (T_i &lt; 4 T_d)</source>
        <translation>die Reihenform hat nur reelle Nullstellen, diese Reglerparameter haben komplexe (T_i &lt; 4 T_d)</translation>
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
        <source>a delay of {} samples is not between 0 and {}</source>
        <translation>eine Totzeit von {} Abtastwerten liegt nicht zwischen 0 und {}</translation>
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
        <source>the d-axis current does not change</source>
        <translation>der Strom der d-Achse ändert sich nicht</translation>
    </message>
    <message>
        <source>the ramp is too short</source>
        <translation>die Rampe ist zu kurz</translation>
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
        <source>no usable plateau</source>
        <translation>kein brauchbares Plateau</translation>
    </message>
    <message>
        <source>use currents above the breakaway current</source>
        <translation>verwenden Sie Ströme über dem Losbrechstrom</translation>
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
        <source>measure more points</source>
        <translation>messen Sie mehr Punkte</translation>
    </message>
    <message>
        <source>hold each current for a second or more, well above the breakaway current</source>
        <translation>halten Sie jeden Strom eine Sekunde oder länger, deutlich über dem Losbrechstrom</translation>
    </message>
    <message>
        <source>an angle of the recording is not a number</source>
        <translation>ein Winkel der Aufzeichnung ist keine Zahl</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs over a wider range of speed</source>
        <translation>zeichnen Sie Hochläufe und Ausläufe über einen weiteren Drehzahlbereich auf</translation>
    </message>
    <message>
        <source>the columns of the recording differ in length</source>
        <translation>die Spalten der Aufzeichnung sind verschieden lang</translation>
    </message>
    <message>
        <source>the time of the recording does not increase</source>
        <translation>die Zeit der Aufzeichnung nimmt nicht zu</translation>
    </message>
    <message>
        <source>a plateau has fewer than three samples</source>
        <translation>ein Plateau hat weniger als drei Abtastwerte</translation>
    </message>
    <message>
        <source>a sample of a plateau is not a finite number</source>
        <translation>ein Abtastwert eines Plateaus ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a plateau is shorter than two windows of the steadiness test</source>
        <translation>ein Plateau ist kürzer als zwei Fenster der Stationaritätsprüfung</translation>
    </message>
    <message>
        <source>a record has too few samples</source>
        <translation>eine Aufzeichnung hat zu wenige Abtastwerte</translation>
    </message>
    <message>
        <source>no run-up and no coast-down</source>
        <translation>kein Hochlauf und kein Auslauf</translation>
    </message>
    <message>
        <source>an angle is not a number</source>
        <translation>ein Winkel ist keine Zahl</translation>
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
        <source>a binary sequence of {} stages held for {} samples is not possible</source>
        <translation>eine Binärfolge von {} Stufen, gehalten für {} Abtastwerte, ist nicht möglich</translation>
    </message>
    <message>
        <source>2 to 16 stages, 1 to 10000 samples</source>
        <translation>2 bis 16 Stufen, 1 bis 10000 Abtastwerte</translation>
    </message>
    <message>
        <source>the recording has no signal &apos;{}&apos;</source>
        <translation>die Aufzeichnung hat kein Signal „{}“</translation>
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
        <source>a recording begins with the line time_s,SIGNAL_UNIT,...; read other tables with &apos;halbench import&apos;</source>
        <translation>eine Aufzeichnung beginnt mit der Zeile time_s,SIGNAL_EINHEIT,...; andere Tabellen liest &apos;halbench import&apos;</translation>
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
        <source>&apos;{}&apos; was changed since it was recorded (SHA-256)</source>
        <translation>„{}“ wurde seit der Aufzeichnung geändert (SHA-256)</translation>
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
        <source>the recording has no parameter &apos;{}&apos;</source>
        <translation>die Aufzeichnung hat keinen Parameter „{}“</translation>
    </message>
    <message>
        <source>list the names with: halbench describe replay:FILE</source>
        <translation>die Namen listet: halbench describe replay:DATEI</translation>
    </message>
    <message>
        <source>the recording ends at {} s</source>
        <translation>die Aufzeichnung endet bei {} s</translation>
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
        <source>&apos;{}&apos; is not HOST:PORT</source>
        <translation>„{}“ ist nicht HOST:PORT</translation>
    </message>
    <message>
        <source>write it like 127.0.0.1:5555 or [::1]:5555, port 0 to 65535</source>
        <translation>schreiben Sie sie wie 127.0.0.1:5555 oder [::1]:5555, Port 0 bis 65535</translation>
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
        <source>the connection is closed</source>
        <translation>die Verbindung ist geschlossen</translation>
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
        <source>record a stream instead</source>
        <translation>zeichnen Sie stattdessen einen Datenstrom auf</translation>
    </message>
    <message>
        <source>leave this signal out</source>
        <translation>lassen Sie dieses Signal weg</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;</source>
        <translation>„{}“ kann nicht geschrieben werden</translation>
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
        <source>verification failed</source>
        <translation>Verifikation fehlgeschlagen</translation>
    </message>
    <message>
        <source>the resource is not accessible now</source>
        <translation>die Ressource ist jetzt nicht zugänglich</translation>
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
        <source>update the board&apos;s firmware</source>
        <translation>aktualisieren Sie die Firmware des Steuergeräts</translation>
    </message>
    <message>
        <source>time unit {} does not exist</source>
        <translation>die Zeiteinheit {} gibt es nicht</translation>
    </message>
    <message>
        <source>these signals have no periodic event</source>
        <translation>diese Signale haben kein periodisches Ereignis</translation>
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
        <source>the board cannot be armed: {}</source>
        <translation>das Steuergerät kann nicht freigegeben werden: {}</translation>
    </message>
    <message>
        <source>remove the cause first</source>
        <translation>zuerst die Ursache beseitigen</translation>
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
        <source>list the names with: halbench describe DEVICE</source>
        <translation>die Namen listet: halbench describe GERÄT</translation>
    </message>
    <message>
        <source>the device has no parameter &apos;{}&apos;</source>
        <translation>das Gerät hat keinen Parameter „{}“</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos;: {}</source>
        <translation>Parameter „{}“: {}</translation>
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
        <source>the board did not store its parameters within {} s</source>
        <translation>das Steuergerät hat seine Parameter nicht innerhalb von {} s gespeichert</translation>
    </message>
    <message>
        <source>try again, then read the values back</source>
        <translation>versuchen Sie es erneut, dann lesen Sie die Werte zurück</translation>
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
        <source>unknown key &apos;{}&apos;; a [[{}]] has name and document</source>
        <translation>unbekannter Schlüssel „{}“; ein [[{}]] hat name und document</translation>
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
        <source>K_P = {} A/rad is {} times the limit of {} A/rad at this sampling and delay</source>
        <translation>K_P = {} A/rad ist das {}-Fache der Grenze von {} A/rad bei dieser Abtastung und Totzeit</translation>
    </message>
    <message>
        <source>friction holds the rotor within +-{} deg of the reference</source>
        <translation>Reibung hält den Rotor innerhalb von ±{} Grad um die Führungsgröße fest</translation>
    </message>
    <message>
        <source>the micro-step assist or a larger K_P narrows the band</source>
        <translation>die Mikroschritthilfe oder ein größeres K_P verengt das Band</translation>
    </message>
    <message>
        <source>switch the compensation on (stray.enabled)</source>
        <translation>schalten Sie die Kompensation ein (stray.enabled)</translation>
    </message>
    <message>
        <source>calibrate the stray field first</source>
        <translation>kalibrieren Sie zuerst das Streufeld</translation>
    </message>
    <message>
        <source>calibrate the stray field again, or lower the gains</source>
        <translation>kalibrieren Sie das Streufeld neu, oder verringern Sie die Reglerparameter</translation>
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
        <source>Verify with a step, ramp, sine or staircase.</source>
        <translation>Weisen Sie mit einem Sprung, einer Rampe, einem Sinus oder einer Treppe nach.</translation>
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
        <source>allow a higher current or speed</source>
        <translation>erlauben Sie mehr Strom oder eine höhere Drehzahl</translation>
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
        <source>another program may be using its capture; try again</source>
        <translation>ein anderes Programm verwendet vielleicht seine Erfassung; versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>a captured value is not a number</source>
        <translation>ein erfasster Wert ist keine Zahl</translation>
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
        <source>a coil temperature is not a number</source>
        <translation>eine Spulentemperatur ist keine Zahl</translation>
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
        <source>friction differs between the directions by {} % of its mean</source>
        <translation>die Reibung unterscheidet sich zwischen den Richtungen um {} % ihres Mittels</translation>
    </message>
    <message>
        <source>the mean of both directions is reported</source>
        <translation>angegeben ist das Mittel beider Richtungen</translation>
    </message>
    <message>
        <source>start the sweep further above the breakaway current</source>
        <translation>beginnen Sie die Messreihe weiter über dem Losbrechstrom</translation>
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
        <source>calibrate the stray field and the Hall sensors, then identify again</source>
        <translation>Streufeld und Hall-Sensoren kalibrieren, dann neu identifizieren</translation>
    </message>
    <message>
        <source>ordinary and robust regression of the sweep differ by more than one standard error</source>
        <translation>gewöhnliche und robuste Regression der Messreihe unterscheiden sich um mehr als einen Standardfehler</translation>
    </message>
    <message>
        <source>residuals keep their sign over neighbouring speeds (runs test, p = {})</source>
        <translation>die Residuen behalten über benachbarte Drehzahlen ihr Vorzeichen (Runs-Test, p = {})</translation>
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
        <source>give the inertia (--given J=...) or the torque constant (--given phi=...), or repeat with a known inertia fixed to the rotor (--bare, --added-inertia)</source>
        <translation>das Trägheitsmoment (--given J=...) oder die Drehmomentkonstante (--given phi=...) angeben, oder mit bekanntem Trägheitsmoment am Rotor wiederholen (--bare, --added-inertia)</translation>
    </message>
    <message>
        <source>identify the bare motor again without --given</source>
        <translation>identifizieren Sie den bloßen Motor neu ohne --given</translation>
    </message>
    <message>
        <source>neither transients nor plateaus could be used: {}; {}</source>
        <translation>weder Übergänge noch Plateaus waren zu verwenden: {}; {}</translation>
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
        <source>Record longer or at a higher rate.</source>
        <translation>Zeichnen Sie länger oder mit höherer Rate auf.</translation>
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
        <source>{} of {} samples arrived</source>
        <translation>{} von {} Abtastwerten kamen an</translation>
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
        <source>reference: &apos;{}&apos; is given twice</source>
        <translation>Verlauf: „{}“ ist zweimal angegeben</translation>
    </message>
    <message>
        <source>{} is not a number at {} s</source>
        <translation>{} ist bei {} s keine Zahl</translation>
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
        <source>a faster loop may be possible: method bandwidth or phase-margin</source>
        <translation>ein schnellerer Regelkreis ist vielleicht möglich: Verfahren bandwidth oder phase-margin</translation>
    </message>
    <message>
        <source>identify the motor to get its uncertainty</source>
        <translation>identifizieren Sie den Motor, um seine Unsicherheit zu erhalten</translation>
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
        <source>give a whole number from {} to {}</source>
        <translation>geben Sie eine ganze Zahl von {} bis {} an</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: sync and escape are the same</source>
        <translation>Gerät „{}“: sync und escape sind gleich</translation>
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
        <source>serial:{}: the device was unplugged or switched off</source>
        <translation>serial:{}: das Gerät wurde abgezogen oder ausgeschaltet</translation>
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
        <source>try again</source>
        <translation>versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>{} is open in another window (process {} on {})</source>
        <translation>{} ist in einem anderen Fenster geöffnet (Prozess {} auf {})</translation>
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
        <source>give milliseconds, e.g. 20</source>
        <translation>Millisekunden angeben, z. B. 20</translation>
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
        <source>the board ran firmware &apos;{}&apos;, but its description was of &apos;{}&apos;: names may have led to wrong values</source>
        <translation>das Steuergerät lief mit Firmware „{}“, ihre Beschreibung war von „{}“: Namen können zu falschen Werten geführt haben</translation>
    </message>
    <message>
        <source>the configuration was read from the device &apos;{}&apos;, this one is &apos;{}&apos;</source>
        <translation>die Konfiguration stammt vom Gerät „{}“, dieses ist „{}“</translation>
    </message>
    <message>
        <source>the configuration was read from firmware &apos;{}&apos;, this device runs &apos;{}&apos;</source>
        <translation>die Konfiguration stammt von der Firmware „{}“, dieses Gerät läuft mit „{}“</translation>
    </message>
    <message>
        <source>the configuration has no value for &apos;{}&apos;</source>
        <translation>die Konfiguration hat keinen Wert für „{}“</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be restored: {}</source>
        <translation>„{}“ kann nicht wiederhergestellt werden: {}</translation>
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
        <source>one row of the recording was lost</source>
        <translation>eine Zeile der Aufzeichnung ging verloren</translation>
    </message>
    <message>
        <source>another device answers at {}: {} instead of {}</source>
        <translation>an {} antwortet ein anderes Gerät: {} statt {}</translation>
    </message>
    <message>
        <source>no device with the serial number &apos;{}&apos; is plugged in</source>
        <translation>kein Gerät mit der Seriennummer &apos;{}&apos; ist eingesteckt</translation>
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
        <source>the description &apos;{}&apos; cannot be read: {}</source>
        <translation>Die Beschreibung &apos;{}&apos; lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>known are baud, dtr, low_latency, framing, header, checksum, sync, escape, a2l</source>
        <translation>bekannt sind baud, dtr, low_latency, framing, header, checksum, sync, escape, a2l</translation>
    </message>
    <message>
        <source>no udev runs here, so that rules have no effect: allow it with &apos;sudo chmod a+rw {}&apos; each time it was plugged in</source>
        <translation>Hier läuft kein udev, Regeln wirken daher nicht: nach jedem Anstecken mit &apos;sudo chmod a+rw {}&apos; erlauben</translation>
    </message>
    <message>
        <source>give the A2L file that belongs to it: DEVICE?a2l=FILE</source>
        <translation>die zugehörige A2L-Datei angeben: GERÄT?a2l=DATEI</translation>
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
        <source>a segment of {} s has fewer than {} rows</source>
        <translation>ein Segment von {} s hat weniger als {} Zeilen</translation>
    </message>
    <message>
        <source>give at least {} s</source>
        <translation>geben Sie mindestens {} s an</translation>
    </message>
    <message>
        <source>give a shorter segment, or record longer</source>
        <translation>geben Sie ein kürzeres Segment an oder zeichnen Sie länger auf</translation>
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
        <source>it is linked more than once</source>
        <translation>auf ihn wird mehr als einmal verwiesen</translation>
    </message>
    <message>
        <source>the file is not finalised</source>
        <translation>die Datei ist nicht abgeschlossen</translation>
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
        <source>the file is not sorted or has several groups</source>
        <translation>die Datei ist nicht sortiert oder hat mehrere Gruppen</translation>
    </message>
    <message>
        <source>it has flags, invalidation bits or a neighbour</source>
        <translation>er hat Merker, Ungültigkeitsbits oder einen Nachbarn</translation>
    </message>
    <message>
        <source>it is of another kind than time and 64-bit floats</source>
        <translation>er ist von anderer Art als Zeit und 64-Bit-Gleitkommazahlen</translation>
    </message>
    <message>
        <source>row {}: the time does not increase</source>
        <translation>Zeile {}: die Zeit nimmt nicht zu</translation>
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
        <source>Good: robustly stable</source>
        <translation>Gut: robust stabil</translation>
    </message>
    <message>
        <source>Good: stable</source>
        <translation>Gut: stabil</translation>
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
        <source>it is the console of this machine</source>
        <translation>Es ist die Konsole dieses Rechners</translation>
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
        <source>unload the driver: sudo modprobe -r {}</source>
        <translation>Treiber entladen: sudo modprobe -r {}</translation>
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
        <source>a move of {} {} leaves the window of {} {} of axis {}</source>
        <translation>eine Bewegung um {} {} verlässt das Fenster von {} {} der Achse {}</translation>
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
        <source>the design is unstable in the sampled loop</source>
        <translation>der Entwurf ist im abgetasteten Kreis instabil</translation>
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
        <source>a constant of the process model is not a finite number</source>
        <translation>eine Konstante des Streckenmodells ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>this tuning rule needs a process with a gain and a lag, and a time to close in</source>
        <translation>diese Einstellregel braucht eine Strecke mit Verstärkung und Verzögerung und eine Zeit für den geschlossenen Kreis</translation>
    </message>
    <message>
        <source>use SIMC or pole placement</source>
        <translation>SIMC oder Polvorgabe verwenden</translation>
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
        <source>SIMC, the internal-model rule of Skogestad, for lag and dead time</source>
        <translation>SIMC, die Regel von Skogestad mit innerem Modell, für Verzögerung und Totzeit</translation>
    </message>
    <message>
        <source>the gains of this rule, K_P = {} A/rad, K_I = {} A/(rad s) and K_D = {} A s/rad, are unstable in the sampled loop: pole radius {}</source>
        <translation>die Verstärkungen dieser Regel, K_P = {} A/rad, K_I = {} A/(rad s) und K_D = {} A s/rad, sind im abgetasteten Regelkreis instabil: Polradius {}</translation>
    </message>
    <message>
        <source>use method bandwidth, phase-margin or lqr</source>
        <translation>verwenden Sie das Verfahren bandwidth, phase-margin oder lqr</translation>
    </message>
    <message>
        <source>a design needs a name</source>
        <translation>ein Entwurf braucht einen Namen</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>wählen Sie einen anderen Namen</translation>
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
        <source>the excitation did not reach the plant</source>
        <translation>Die Anregung hat die Strecke nicht erreicht</translation>
    </message>
    <message>
        <source>too few usable frequencies for a fit of the rotor</source>
        <translation>zu wenige brauchbare Frequenzen, um den Rotor anzupassen</translation>
    </message>
    <message>
        <source>use a smaller amplitude</source>
        <translation>eine kleinere Amplitude verwenden</translation>
    </message>
    <message>
        <source>measure more frequencies, from 0.5 Hz or lower</source>
        <translation>mehr Frequenzen messen, ab 0,5 Hz oder tiefer</translation>
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
        <source>amplitude in rad</source>
        <translation>Amplitude in rad</translation>
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
        <source>set control.law=0 first; nothing was armed</source>
        <translation>zuerst control.law=0 setzen; nichts wurde freigegeben</translation>
    </message>
    <message>
        <source>use a stepped sine</source>
        <translation>einen gestuften Sinus verwenden</translation>
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
        <source>&apos;{}&apos; defines no signal</source>
        <translation>„{}“ legt kein Signal fest</translation>
    </message>
    <message>
        <source>write NAME = EXPRESSION or NAME [UNIT] = EXPRESSION</source>
        <translation>schreiben Sie NAME = AUSDRUCK oder NAME [EINHEIT] = AUSDRUCK</translation>
    </message>
    <message>
        <source>operators are + - * / ^ and comparisons, functions sin, cos, atan2, sqrt, abs, exp, ln, min, max</source>
        <translation>Operatoren sind + - * / ^ und Vergleiche, Funktionen sin, cos, atan2, sqrt, abs, exp, ln, min, max</translation>
    </message>
    <message>
        <source>the expression has several results</source>
        <translation>der Ausdruck hat mehrere Ergebnisse</translation>
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
        <source>&apos;{}&apos; is damaged</source>
        <translation>&apos;{}&apos; ist beschädigt</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no rows</source>
        <translation>„{}“ hat keine Zeilen</translation>
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
        <source>{}: sample_period_s: must be more than zero</source>
        <translation>{}: sample_period_s: muss größer als null sein</translation>
    </message>
    <message>
        <source>damaged (checksum)</source>
        <translation>beschädigt (Prüfsumme)</translation>
    </message>
    <message>
        <source>cannot keep history in &apos;{}&apos;: {}</source>
        <translation>der Verlauf kann nicht in „{}“ abgelegt werden: {}</translation>
    </message>
    <message>
        <source>more than {} characters in a line</source>
        <translation>mehr als {} Zeichen in einer Zeile</translation>
    </message>
    <message>
        <source>its numbers need more than {} MB of memory</source>
        <translation>ihre Zahlen brauchen mehr als {} MB Arbeitsspeicher</translation>
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
        <source>update Halbench, or the board&apos;s firmware</source>
        <translation>Halbench oder die Firmware des Steuergeräts aktualisieren</translation>
    </message>
    <message>
        <source>the crossover or margin asked for is not a finite number</source>
        <translation>die verlangte Durchtrittsfrequenz oder Reserve ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>identify the motor again, or choose a design method</source>
        <translation>identifizieren Sie den Motor neu, oder wählen Sie ein Auslegungsverfahren</translation>
    </message>
    <message>
        <source>the device has no axis &apos;{}&apos;</source>
        <translation>das Gerät hat keine Achse &apos;{}&apos;</translation>
    </message>
    <message>
        <source>a band of steps of this height and length is not possible</source>
        <translation>ein Band von Sprüngen dieser Höhe und Länge ist nicht möglich</translation>
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
        <source>for example s, ms, us, rad, deg, rad/s, rpm, A, mA, T, mT, degC, or - for none</source>
        <translation>zum Beispiel s, ms, us, rad, deg, rad/s, rpm, A, mA, T, mT, degC, oder - für keine</translation>
    </message>
    <message>
        <source>column {}</source>
        <translation>Spalte {}</translation>
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
        <source>UTF-16 text</source>
        <translation>UTF-16-Text</translation>
    </message>
    <message>
        <source>save it as text in UTF-8</source>
        <translation>speichern Sie sie als Text in UTF-8</translation>
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
        <source>{} rows are missing</source>
        <translation>{} Zeilen fehlen</translation>
    </message>
    <message>
        <source>a [[plot]] with its own time axis has own_span_s, which is more than 0</source>
        <translation>ein [[plot]] mit eigener Zeitachse hat own_span_s, größer als 0</translation>
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
        <source>allow at least 1.05</source>
        <translation>mindestens 1,05 zulassen</translation>
    </message>
    <message>
        <source>step {} of {}: {}</source>
        <translation>Schritt {} von {}: {}</translation>
    </message>
    <message>
        <source>the new gains were not kept</source>
        <translation>die neuen Reglerparameter wurden nicht behalten</translation>
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
        <source>record the move again, at 100 Hz or more</source>
        <translation>die Bewegung erneut aufzeichnen, mit 100 Hz oder mehr</translation>
    </message>
    <message>
        <source>the recording has no {}</source>
        <translation>die Aufzeichnung hat kein {}</translation>
    </message>
    <message>
        <source>name mask, character {}: {}</source>
        <translation>Namensmaske, Zeichen {}: {}</translation>
    </message>
    <message>
        <source>there is no placeholder &apos;{}&apos;</source>
        <translation>es gibt keinen Platzhalter „{}“</translation>
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
        <source>the name mask is empty</source>
        <translation>die Namensmaske ist leer</translation>
    </message>
    <message>
        <source>begin with a letter</source>
        <translation>beginnen Sie mit einem Buchstaben</translation>
    </message>
    <message>
        <source>cannot remove &apos;{}&apos;: {}</source>
        <translation>„{}“ lässt sich nicht entfernen: {}</translation>
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
        <source>it is open</source>
        <translation>sie ist offen</translation>
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
        <source>the target {} = {} is not between {} and {}</source>
        <translation>das Ziel {} = {} liegt nicht zwischen {} und {}</translation>
    </message>
    <message>
        <source>the target step-deg needs the target current-limit-a</source>
        <translation>das Ziel step-deg braucht das Ziel current-limit-a</translation>
    </message>
    <message>
        <source>allow more current, or a smaller step</source>
        <translation>mehr Strom oder einen kleineren Sprung zulassen</translation>
    </message>
    <message>
        <source>any motion</source>
        <translation>jede Bewegung</translation>
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
        <source>measure more cycles; calibrate the sensors first</source>
        <translation>messen Sie mehr Schwingungen; kalibrieren Sie zuerst die Sensoren</translation>
    </message>
    <message>
        <source>identify the motor and give its model</source>
        <translation>Motor identifizieren und sein Modell angeben</translation>
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
        <source>the device has no parameter for {}</source>
        <translation>das Gerät hat keinen Parameter für {}</translation>
    </message>
    <message>
        <source>the relay experiment needs a position loop with a gain and a current limit</source>
        <translation>der Relaisversuch braucht einen Lageregelkreis mit einer Verstärkung und einer Stromgrenze</translation>
    </message>
    <message>
        <source>{}: {} was changed at {} s of the recording</source>
        <translation>{}: {} wurde bei {} s der Aufzeichnung geändert</translation>
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
        <source>design them for the timing of this device</source>
        <translation>für das Zeitverhalten dieses Geräts entwerfen</translation>
    </message>
    <message>
        <source>{}; nothing was written</source>
        <translation>{}; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>[monitor] has follow and cursors (true or false), span_s, rate_hz, curves and trigger</source>
        <translation>[monitor] hat follow und cursors (true oder false), span_s, rate_hz, curves und trigger</translation>
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
        <source>a band under a load of {} A is not possible</source>
        <translation>ein Band unter einer Last von {} A ist nicht möglich</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; known are schema, device, notes, perspective, layout, monitor, monitor2, monitor3, recording, plot, cursors, derived, given, model, design, calibration</source>
        <translation>unbekannter Schlüssel „{}“; bekannt sind schema, device, notes, perspective, layout, monitor, monitor2, monitor3, recording, plot, cursors, derived, given, model, design, calibration</translation>
    </message>
    <message>
        <source>a set-point weight is not a finite number</source>
        <translation>eine Sollwertgewichtung ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the set-point weight {} = {} is not between 0 and 1</source>
        <translation>die Sollwertgewichtung {} = {} liegt nicht zwischen 0 und 1</translation>
    </message>
    <message>
        <source>&apos;units&apos; must be a table of signals with their units, units.position = &quot;mrad&quot;</source>
        <translation>„units“ muss eine Tabelle von Signalen mit ihren Einheiten sein, units.position = &quot;mrad&quot;</translation>
    </message>
    <message>
        <source>&apos;units&apos; names &apos;{}&apos;, which this [[plot]] does not show</source>
        <translation>„units“ nennt „{}“, was dieses [[plot]] nicht zeigt</translation>
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
        <source>&apos;{}&apos; is a device or pipe</source>
        <translation>„{}“ ist ein Gerät oder eine Pipe</translation>
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
        <source>the motor was measured at {} s with {} samples of delay, this device has {} s and {}</source>
        <translation>der Motor wurde mit {} s und {} Abtastungen Verzögerung gemessen, dieses Gerät hat {} s und {}</translation>
    </message>
    <message>
        <source>turns against its current</source>
        <translation>dreht gegen seinen Strom</translation>
    </message>
    <message>
        <source>current of {} A, above the limit of {} A of the recorded device</source>
        <translation>Strom von {} A, über dem Grenzwert von {} A des aufgezeichneten Geräts</translation>
    </message>
    <message>
        <source>check unit and scale of the current column, e.g. current_command_mA</source>
        <translation>Einheit und Skalierung der Stromspalte prüfen, z. B. current_command_mA</translation>
    </message>
    <message>
        <source>current of {} A, implausible for an actuator of this kind</source>
        <translation>Strom von {} A, unplausibel für einen solchen Aktor</translation>
    </message>
    <message>
        <source>wrong sign of current or angle: {}</source>
        <translation>falsches Vorzeichen von Strom oder Winkel: {}</translation>
    </message>
    <message>
        <source>record more run-ups and coast-downs, over a wider range of speed</source>
        <translation>mehr Hochläufe und Ausläufe über einen größeren Drehzahlbereich aufzeichnen</translation>
    </message>
    <message>
        <source>the value is zero and its interval begins there</source>
        <translation>der Wert ist null, und dort beginnt sein Intervall</translation>
    </message>
    <message>
        <source>check the given constants, and the units of current and angle</source>
        <translation>prüfen Sie die angegebenen Konstanten und die Einheiten von Strom und Winkel</translation>
    </message>
    <message>
        <source>record the position, or rename the columns</source>
        <translation>zeichnen Sie die Position auf oder benennen Sie die Spalten um</translation>
    </message>
    <message>
        <source>the rotor turns against its current</source>
        <translation>der Rotor dreht gegen seinen Strom</translation>
    </message>
    <message>
        <source>shorten or shield the cable, or lower the baud rate</source>
        <translation>kürzen oder schirmen Sie das Kabel, oder senken Sie die Baudrate</translation>
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
        <translation>Eine Zahl des kugelförmigen Rotors ist nicht endlich.</translation>
    </message>
    <message>
        <source>The outer radius of the magnet must be larger than the radius of its core.</source>
        <translation>Der Außenradius des Magneten muss größer sein als der Radius seines Kerns.</translation>
    </message>
    <message>
        <source>Relative permeabilities of the rotor are at least 1.</source>
        <translation>Relative Permeabilitäten des Rotors sind mindestens 1.</translation>
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
        <source>Place it outside the rotor&apos;s outer radius.</source>
        <translation>Außerhalb des Außenradius des Rotors anordnen.</translation>
    </message>
    <message>
        <source>The three axes of a field sensor must be unit vectors that span the space.</source>
        <translation>Die drei Achsen eines Feldsensors müssen Einheitsvektoren sein, die den Raum aufspannen.</translation>
    </message>
    <message>
        <source>Each of the three sensors needs a place of its own.</source>
        <translation>Jeder der drei Sensoren braucht eine eigene Stelle.</translation>
    </message>
    <message>
        <source>record more run-ups and coast-downs at different currents, in both directions</source>
        <translation>mehr Hoch- und Ausläufe mit verschiedenen Strömen in beiden Richtungen aufzeichnen</translation>
    </message>
    <message>
        <source>friction falls with the speed (Stribeck): at {} rad/s it is higher by {}, above about {} rad/s it is constant</source>
        <translation>die Reibung fällt mit der Drehzahl (Stribeck): bei {} rad/s ist sie um {} höher, über etwa {} rad/s ist sie konstant</translation>
    </message>
    <message>
        <source>model inadequate: the damping differs between the directions</source>
        <translation>Modell unzureichend: die Dämpfung unterscheidet sich zwischen den Richtungen</translation>
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
        <translation>Die Sensoren bestimmen das Feld des Rotors nicht.</translation>
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
        <translation>Eine Zahl der Rotorbewegung ist nicht endlich.</translation>
    </message>
    <message>
        <source>The rotor&apos;s motion needs a positive rate, sample time and tilt of at most 180 degrees.</source>
        <translation>Die Rotorbewegung braucht eine positive Drehrate, eine positive Abtastzeit und eine positive Neigung von höchstens 180 Grad.</translation>
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
        <translation>Die Stärke q des Rotorfelds muss positiv sein.</translation>
    </message>
    <message>
        <source>The reference radius of the rotor&apos;s field must be positive.</source>
        <translation>Der Bezugsradius des Rotorfelds muss positiv sein.</translation>
    </message>
    <message>
        <source>The estimators need harmonics of even degree and even order.</source>
        <translation>Die Schätzer brauchen Kugelflächenfunktionen von geradem Grad und gerader Ordnung.</translation>
    </message>
    <message>
        <source>Others break the symmetry of the four-pole rotor.</source>
        <translation>Andere brechen die Symmetrie des vierpoligen Rotors.</translation>
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
        <source>set-point weight b</source>
        <translation>Sollwertgewichtung b</translation>
    </message>
    <message>
        <source>set-point weight c</source>
        <translation>Sollwertgewichtung c</translation>
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
        <source>, no </source>
        <translation>, </translation>
    </message>
    <message>
        <source>The closed form of the additive model needs sensor 1 at (0, 0, 45 degrees).</source>
        <translation>Die geschlossene Form des additiven Modells braucht Sensor 1 bei (0, 0, 45 Grad).</translation>
    </message>
    <message>
        <source>a bandwidth of {} Hz is not possible on this axis at {} Hz sampling and {} samples of delay</source>
        <translation>eine Bandbreite von {} Hz ist auf dieser Achse bei {} Hz Abtastung und {} Abtastwerten Verzögerung nicht möglich</translation>
    </message>
    <message>
        <source>axis {}: {}</source>
        <translation>Achse {}: {}</translation>
    </message>
    <message>
        <source>{} is in &quot;{}&quot;, not in &quot;{}&quot;</source>
        <translation>{} ist in „{}“, nicht in „{}“</translation>
    </message>
    <message>
        <source>identify the axis again</source>
        <translation>die Achse neu identifizieren</translation>
    </message>
    <message>
        <source>{} = {} must {}</source>
        <translation>{} = {} darf {}</translation>
    </message>
    <message>
        <source>not be negative</source>
        <translation>nicht negativ sein</translation>
    </message>
    <message>
        <source>be positive</source>
        <translation>nur positiv sein</translation>
    </message>
    <message>
        <source>an axis of the model has no name</source>
        <translation>eine Achse des Modells hat keinen Namen</translation>
    </message>
    <message>
        <source>name every axis</source>
        <translation>jede Achse benennen</translation>
    </message>
    <message>
        <source>use rad or m</source>
        <translation>rad oder m verwenden</translation>
    </message>
    <message>
        <source>damping rate</source>
        <translation>Dämpfungsrate</translation>
    </message>
    <message>
        <source>acceleration gain</source>
        <translation>Beschleunigungsverstärkung</translation>
    </message>
    <message>
        <source>axis {}</source>
        <translation>Achse {}</translation>
    </message>
    <message>
        <source>{}: damping rate</source>
        <translation>{}: Dämpfungsrate</translation>
    </message>
    <message>
        <source>{}: acceleration gain</source>
        <translation>{}: Beschleunigungsverstärkung</translation>
    </message>
    <message>
        <source>{}: breakaway effort</source>
        <translation>{}: Losbrechkraft</translation>
    </message>
    <message>
        <source>name AXIS.damping_rate, AXIS.acceleration_gain, AXIS.breakaway_effort</source>
        <translation>AXIS.damping_rate, AXIS.acceleration_gain, AXIS.breakaway_effort nennen</translation>
    </message>
    <message>
        <source>the covariance needs as many rows and columns of finite numbers as names</source>
        <translation>die Kovarianz braucht so viele Zeilen und Spalten endlicher Zahlen wie Namen</translation>
    </message>
    <message>
        <source>identify the axes again</source>
        <translation>die Achsen neu identifizieren</translation>
    </message>
    <message>
        <source>the model has no axis</source>
        <translation>das Modell hat keine Achse</translation>
    </message>
    <message>
        <source>{}, or use method recommended</source>
        <translation>{}, oder das Verfahren recommended verwenden</translation>
    </message>
    <message>
        <source>with friction and the effort limit of {} {} a step of {} overshoots by {} %</source>
        <translation>mit Reibung und der Stellgrenze von {} {} schwingt ein Sprung von {} um {} % über</translation>
    </message>
    <message>
        <source>friction holds the axis within {} of the reference</source>
        <translation>die Reibung hält die Achse innerhalb von {} um den Sollwert</translation>
    </message>
    <message>
        <source>identify the axis to get its uncertainty</source>
        <translation>die Achse identifizieren, um ihre Unsicherheit zu erhalten</translation>
    </message>
    <message>
        <source>the model has no axis &apos;{}&apos;</source>
        <translation>das Modell hat keine Achse &apos;{}&apos;</translation>
    </message>
    <message>
        <source>Half-angle of the cone that holds the shaft with 95 %</source>
        <translation>Halber Öffnungswinkel des Kegels, in dem die Welle mit 95 % liegt</translation>
    </message>
    <message>
        <source>the excited rows are not whole periods of all signals</source>
        <translation>Die angeregten Zeilen sind nicht ganze Perioden aller Signale</translation>
    </message>
    <message>
        <source>there is no excited row of any axis</source>
        <translation>Es gibt keine angeregte Zeile einer Achse</translation>
    </message>
    <message>
        <source>{} experiments do not decide {} inputs</source>
        <translation>{} Versuche bestimmen {} Eingänge nicht</translation>
    </message>
    <message>
        <source>measure as many as there are inputs</source>
        <translation>So viele messen, wie es Eingänge gibt</translation>
    </message>
    <message>
        <source>the experiments do not have the same axes</source>
        <translation>Die Versuche haben nicht dieselben Achsen</translation>
    </message>
    <message>
        <source>the excitation did not reach every axis at {} Hz</source>
        <translation>Die Anregung hat bei {} Hz nicht jede Achse erreicht</translation>
    </message>
    <message>
        <source>check that the excitation ran on all of them</source>
        <translation>Prüfen, ob die Anregung auf allen lief</translation>
    </message>
    <message>
        <source>tries the excitation</source>
        <translation>erprobt die Anregung</translation>
    </message>
    <message>
        <source>excites from {} to {} Hz, {} of {}</source>
        <translation>regt von {} bis {} Hz an, {} von {}</translation>
    </message>
    <message>
        <source>the board cannot add an excitation to the command of axis {}</source>
        <translation>Das Steuergerät kann dem Stellbefehl der Achse {} keine Anregung hinzufügen</translation>
    </message>
    <message>
        <source>it needs a parameter &apos;{}&apos; and a signal of the command</source>
        <translation>Es braucht einen Parameter &apos;{}&apos; und ein Signal des Stellbefehls</translation>
    </message>
    <message>
        <source>the effort that axis {} has at its limit is not known</source>
        <translation>Die Stellgröße, die Achse {} an ihrer Grenze hat, ist nicht bekannt</translation>
    </message>
    <message>
        <source>add effort_limit to the axis in the profile of the device</source>
        <translation>Bei der Achse im Profil des Geräts effort_limit eintragen</translation>
    </message>
    <message>
        <source>the recording lacks the signal &apos;{}&apos;</source>
        <translation>Der Aufzeichnung fehlt das Signal &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the device must send position and command of every axis</source>
        <translation>Das Gerät muss Position und Stellbefehl jeder Achse senden</translation>
    </message>
    <message>
        <source>rows are missing in the band from {} Hz: the periods do not fit together</source>
        <translation>Im Band ab {} Hz fehlen Zeilen: Die Perioden passen nicht zusammen</translation>
    </message>
    <message>
        <source>axis {}: no phase margin: the loop crosses nowhere on the frequencies that are used</source>
        <translation>Achse {}: keine Phasenreserve: Der Kreis hat auf den verwendeten Frequenzen keinen Durchtritt</translation>
    </message>
    <message>
        <source>axis {}: no phase margin: the loop crosses where frequencies were left out or are far apart</source>
        <translation>Achse {}: keine Phasenreserve: Der Durchtritt liegt, wo Frequenzen ausgelassen wurden oder weit auseinander liegen</translation>
    </message>
    <message>
        <source>axis {}: no phase margin: its interval is {} deg to either side</source>
        <translation>Achse {}: keine Phasenreserve: Ihr Intervall beträgt {} Grad nach jeder Seite</translation>
    </message>
    <message>
        <source>{} deg are allowed: measure more periods or with more effort</source>
        <translation>{} Grad sind erlaubt: Mehr Perioden oder mit mehr Stellgröße messen</translation>
    </message>
    <message>
        <source>axis {}: no gain margin: the loop crosses nowhere on the frequencies that are used</source>
        <translation>Achse {}: keine Amplitudenreserve: Der Kreis hat auf den verwendeten Frequenzen keinen Durchtritt</translation>
    </message>
    <message>
        <source>axis {}: no gain margin: the loop crosses where frequencies were left out or are far apart</source>
        <translation>Achse {}: keine Amplitudenreserve: Der Durchtritt liegt, wo Frequenzen ausgelassen wurden oder weit auseinander liegen</translation>
    </message>
    <message>
        <source>axis {}: no gain margin: its interval is {} dB to either side</source>
        <translation>Achse {}: keine Amplitudenreserve: Ihr Intervall beträgt {} dB nach jeder Seite</translation>
    </message>
    <message>
        <source>{} dB are allowed: measure more periods or with more effort</source>
        <translation>{} dB sind erlaubt: Mehr Perioden oder mit mehr Stellgröße messen</translation>
    </message>
    <message>
        <source>measure with more periods or more effort there</source>
        <translation>Dort mit mehr Perioden oder mehr Stellgröße messen</translation>
    </message>
    <message>
        <source>axis {}: {} of {} frequencies have a coherence below {} and were left out</source>
        <translation>Achse {}: {} von {} Frequenzen haben eine Kohärenz unter {} und wurden ausgelassen</translation>
    </message>
    <message>
        <source>measure more periods or with more effort</source>
        <translation>Mehr Perioden oder mit mehr Stellgröße messen</translation>
    </message>
    <message>
        <source>no peak of the sensitivity: it is largest at the end of the frequencies that are used</source>
        <translation>Keine Spitze der Empfindlichkeit: Sie ist am Ende der verwendeten Frequenzen am größten</translation>
    </message>
    <message>
        <source>no peak of the sensitivity: at no frequency all axes are coherent</source>
        <translation>Keine Spitze der Empfindlichkeit: Bei keiner Frequenz sind alle Achsen kohärent</translation>
    </message>
    <message>
        <source>no peak of the complementary sensitivity: it is largest at the end of the frequencies that are used</source>
        <translation>Keine Spitze der komplementären Empfindlichkeit: Sie ist am Ende der verwendeten Frequenzen am größten</translation>
    </message>
    <message>
        <source>no peak of the complementary sensitivity: at no frequency all axes are coherent</source>
        <translation>Keine Spitze der komplementären Empfindlichkeit: Bei keiner Frequenz sind alle Achsen kohärent</translation>
    </message>
    <message>
        <source>in {} % of the samples the currents were at their limit: the command did not flow as told</source>
        <translation>In {} % der Abtastwerte waren die Ströme an ihrer Grenze: Der Stellbefehl floss nicht wie gemeldet</translation>
    </message>
    <message>
        <source>measure with less effort</source>
        <translation>Mit weniger Stellgröße messen</translation>
    </message>
    <message>
        <source>lowest frequency (Hz)</source>
        <translation>tiefste Frequenz (Hz)</translation>
    </message>
    <message>
        <source>highest frequency (Hz)</source>
        <translation>höchste Frequenz (Hz)</translation>
    </message>
    <message>
        <source>{} to {} Hz is less than an octave</source>
        <translation>{} bis {} Hz ist weniger als eine Oktave</translation>
    </message>
    <message>
        <source>widen the band: margins need neighbours on both sides</source>
        <translation>Das Band erweitern: Reserven brauchen Nachbarn auf beiden Seiten</translation>
    </message>
    <message>
        <source>effort of each axis over its limit</source>
        <translation>Stellgröße jeder Achse zu ihrer Grenze</translation>
    </message>
    <message>
        <source>from {} to {} Hz there is no room for two lines of each axis</source>
        <translation>Von {} bis {} Hz ist kein Platz für zwei Linien jeder Achse</translation>
    </message>
    <message>
        <source>measure from a lower or to a higher frequency</source>
        <translation>Ab einer tieferen oder bis zu einer höheren Frequenz messen</translation>
    </message>
    <message>
        <source>the board went on without one of its sensors: the position changed its noise and its errors meanwhile</source>
        <translation>Das Steuergerät fuhr ohne einen seiner Sensoren fort: Rauschen und Fehler der Position änderten sich währenddessen</translation>
    </message>
    <message>
        <source>check the sensors and their cables, and measure again</source>
        <translation>Die Sensoren und ihre Kabel prüfen und noch einmal messen</translation>
    </message>
    <message>
        <source>correct the line or open an earlier copy; the help shows the form of the files</source>
        <translation>die Zeile berichtigen oder eine frühere Fassung öffnen; die Hilfe zeigt die Form der Dateien</translation>
    </message>
    <message>
        <source>the sensors of this device need no calibration</source>
        <translation>die Sensoren dieses Geräts brauchen keine Kalibrierung</translation>
    </message>
    <message>
        <source>use identify or record</source>
        <translation>Identifizieren oder Aufzeichnen verwenden</translation>
    </message>
    <message>
        <source>force per effort</source>
        <translation>Kraft je Stellgröße</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{} von {}</translation>
    </message>
    <message>
        <source>The motion does not excite the axis enough: check that nothing holds it.</source>
        <translation>Die Bewegung regt die Achse zu wenig an: Prüfen, dass nichts sie festhält.</translation>
    </message>
    <message>
        <source>axis {}: damping, friction and effort leave {} % of the acceleration unexplained</source>
        <translation>Achse {}: Dämpfung, Reibung und Stellgröße erklären {} % der Beschleunigung nicht</translation>
    </message>
    <message>
        <source>The axis has a force that depends on the position, or another axis acts on it.</source>
        <translation>Auf die Achse wirkt eine Kraft, die von der Position abhängt, oder eine andere Achse.</translation>
    </message>
    <message>
        <source>Design with the upper bound, or identify again with a wider window.</source>
        <translation>Mit der oberen Grenze auslegen oder mit einem weiteren Fenster erneut identifizieren.</translation>
    </message>
    <message>
        <source>Nothing to do where the axis has none.</source>
        <translation>Nichts zu tun, wenn die Achse keine hat.</translation>
    </message>
    <message>
        <source>axis {}: {} of {} windows of the motion miss rows</source>
        <translation>Achse {}: {} von {} Fenstern der Bewegung fehlen Zeilen</translation>
    </message>
    <message>
        <source>only ratios follow from the motion: damping, friction and force have no absolute value</source>
        <translation>Aus der Bewegung folgen nur Verhältnisse: Dämpfung, Reibung und Kraft haben keinen absoluten Wert</translation>
    </message>
    <message>
        <source>Weigh a slide and give its mass: --given m=0.2, in an experiment given = { m = 0.2 }.</source>
        <translation>Einen Schlitten wiegen und seine Masse angeben: --given m=0.2, in einem Experiment given = { m = 0.2 }.</translation>
    </message>
    <message>
        <source>this device has no constant &apos;{}&apos;</source>
        <translation>dieses Gerät hat keine Konstante &apos;{}&apos;</translation>
    </message>
    <message>
        <source>known is m (moving mass of an axis, kg)</source>
        <translation>bekannt ist m (bewegte Masse einer Achse, kg)</translation>
    </message>
    <message>
        <source>leave them out; this device takes an axis and a given m</source>
        <translation>weglassen; dieses Gerät nimmt eine Achse und eine Masse m</translation>
    </message>
    <message>
        <source>Check that nothing holds the axis, and that it follows its reference.</source>
        <translation>Prüfen, dass nichts die Achse festhält und dass sie ihrem Sollwert folgt.</translation>
    </message>
    <message>
        <source>only {} of {} stretches of {} s in steady motion</source>
        <translation>nur {} von {} Abschnitten von {} s in stetiger Bewegung</translation>
    </message>
    <message>
        <source>the axis moved one way only</source>
        <translation>die Achse bewegte sich nur nach einer Seite</translation>
    </message>
    <message>
        <source>the effort shows no effect on the motion within 8 rows</source>
        <translation>die Stellgröße zeigt innerhalb von 8 Zeilen keine Wirkung auf die Bewegung</translation>
    </message>
    <message>
        <source>the delay of the effort is not decided by the motion</source>
        <translation>die Verzögerung der Stellgröße ist aus der Bewegung nicht bestimmbar</translation>
    </message>
    <message>
        <source>runs with a sine on its speed</source>
        <translation>fährt mit einem Sinus auf der Geschwindigkeit</translation>
    </message>
    <message>
        <source>goes to its place</source>
        <translation>fährt an seinen Platz</translation>
    </message>
    <message>
        <source>axis {} {}</source>
        <translation>Achse {} {}</translation>
    </message>
    <message>
        <source>the device lacks position or effort of axis {}</source>
        <translation>dem Gerät fehlt Position oder Stellgröße der Achse {}</translation>
    </message>
    <message>
        <source>Its profile needs both roles.</source>
        <translation>Sein Profil braucht beide Rollen.</translation>
    </message>
    <message>
        <source>axis {}: damping changes with the speed, the intervals do not include it</source>
        <translation>Achse {}: Dämpfung ändert sich mit der Geschwindigkeit, die Intervalle enthalten das nicht</translation>
    </message>
    <message>
        <source>Use the values near the speeds of the motion only; look for drag, or friction that grows with the speed.</source>
        <translation>Werte nur nahe den Geschwindigkeiten der Bewegung verwenden; nach Luftwiderstand suchen oder nach Reibung, die mit der Geschwindigkeit wächst.</translation>
    </message>
    <message>
        <source>axis {}: negative friction, not possible</source>
        <translation>Achse {}: negative Reibung, nicht möglich</translation>
    </message>
    <message>
        <source>axis {}: negative damping, not possible</source>
        <translation>Achse {}: negative Dämpfung, nicht möglich</translation>
    </message>
    <message>
        <source>The axis has a force that the model lacks, or position and effort are shifted in time.</source>
        <translation>Auf die Achse wirkt eine Kraft, die dem Modell fehlt, oder Position und Stellgröße sind zeitlich verschoben.</translation>
    </message>
    <message>
        <source>Nothing was changed. Take the load of cable or tilt off the platen, clear the stop, move the platen to the middle, and start again.</source>
        <translation>Nichts wurde geändert. Nehmen Sie der Platte die Last von Kabel oder Neigung, heben Sie den Stopp auf, bewegen Sie die Platte zur Mitte und beginnen Sie neu.</translation>
    </message>
    <message>
        <source>the gains are for a device &apos;{}&apos;, the model is of a &apos;{}&apos;</source>
        <translation>die Reglerparameter sind für ein Gerät &apos;{}&apos;, das Modell ist von &apos;{}&apos;</translation>
    </message>
    <message>
        <source>open gains that were found with a model of this kind of device</source>
        <translation>öffnen Sie Reglerparameter, die mit einem Modell dieser Art von Gerät bestimmt wurden</translation>
    </message>
    <message>
        <source>the gains are for axes {}, the model has {}</source>
        <translation>die Reglerparameter sind für die Achsen {}, das Modell hat {}</translation>
    </message>
    <message>
        <source>open gains for an axis of the model</source>
        <translation>öffnen Sie Reglerparameter für eine Achse des Modells</translation>
    </message>
    <message>
        <source>a path does not alternate its direction</source>
        <translation>eine Bahn wechselt ihre Richtung nicht</translation>
    </message>
    <message>
        <source>repeat it as it is: it ends where its last line ends</source>
        <translation>wiederholen Sie sie, wie sie ist: sie endet, wo ihre letzte Zeile endet</translation>
    </message>
    <message>
        <source>{} and {} are the same value</source>
        <translation>{} und {} sind derselbe Wert</translation>
    </message>
    <message>
        <source>Give one of them.</source>
        <translation>Geben Sie nur einen davon an.</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not in {}</source>
        <translation>„{}“ ist nicht in {}</translation>
    </message>
    <message>
        <source>give the unit of its numbers, e.g. {}: halbench import --unit COLUMN=UNIT --map {}=COLUMN</source>
        <translation>Geben Sie die Einheit der Zahlen an, z. B. {}: halbench import --unit COLUMN=UNIT --map {}=COLUMN</translation>
    </message>
    <message>
        <source>there are {}</source>
        <translation>vorhanden sind {}</translation>
    </message>
    <message>
        <source>sensor {} gave no reading in the whole record</source>
        <translation>Sensor {} lieferte in der ganzen Aufzeichnung keinen Messwert</translation>
    </message>
    <message>
        <source>Connect it, or check channels.off and its range: the calibration needs all three sensors.</source>
        <translation>Schließen Sie ihn an, oder prüfen Sie channels.off und seinen Messbereich: Die Kalibrierung braucht alle drei Sensoren.</translation>
    </message>
    <message>
        <source>{} gave no reading: its gain and offset keep their values</source>
        <translation>{} lieferte keinen Messwert: Verstärkung und Offset behalten ihre Werte</translation>
    </message>
    <message>
        <source>Leave it out with channels.off, or repair it and calibrate again.</source>
        <translation>Lassen Sie ihn mit channels.off aus, oder reparieren Sie ihn und kalibrieren Sie erneut.</translation>
    </message>
    <message>
        <source>The common sign of all readings is not observable without a known orientation: reversed, they are those of a rotor that is spun by 90 degrees.</source>
        <translation>Das gemeinsame Vorzeichen aller Messwerte ist ohne bekannte Orientierung nicht beobachtbar: Umgekehrt sind es die eines um 90 Grad gedrehten Rotors.</translation>
    </message>
    <message>
        <source>Compare one orientation with the rotor, or record reference.alpha, .beta and .gamma.</source>
        <translation>Vergleichen Sie eine Orientierung mit dem Rotor, oder zeichnen Sie reference.alpha, .beta und .gamma auf.</translation>
    </message>
    <message>
        <source>: sensor {} is missing</source>
        <translation>: Sensor {} fehlt</translation>
    </message>
    <message>
        <source>A calibration needs nine fields, field.0.r, field.0.theta ... field.2.phi; record all sensors, or rename columns with halbench import --map. There are {}.</source>
        <translation>Eine Kalibrierung braucht neun Felder, field.0.r, field.0.theta ... field.2.phi; zeichnen Sie alle Sensoren auf, oder benennen Sie Spalten mit halbench import --map um. Vorhanden sind {}.</translation>
    </message>
    <message>
        <source>the known orientation at {} s is beyond one turn, {} rad: it is in degrees</source>
        <translation>Die bekannte Orientierung bei {} s liegt jenseits einer Umdrehung, {} rad: Sie ist in Grad</translation>
    </message>
    <message>
        <source>Give the unit of its columns: halbench import --unit COLUMN=deg.</source>
        <translation>Geben Sie die Einheit der Spalten an: halbench import --unit COLUMN=deg.</translation>
    </message>
    <message>
        <source>Check the wiring and the direction of the sensors, reverse the sign of these columns and calibrate again.</source>
        <translation>Prüfen Sie Verdrahtung und Richtung der Sensoren, kehren Sie das Vorzeichen dieser Spalten um und kalibrieren Sie erneut.</translation>
    </message>
    <message>
        <source>{} read with the opposite sign of the others</source>
        <translation>{}: Vorzeichen entgegengesetzt zu den anderen</translation>
    </message>
    <message>
        <source>the known orientations differ from those of the readings by {} degrees (median)</source>
        <translation>Die bekannten Orientierungen weichen um {} Grad (Median) von denen der Messwerte ab</translation>
    </message>
    <message>
        <source>Check their unit, the order of the rotations (Z, then Y, then X of the stator), their time base and the placement of the sensors.</source>
        <translation>Prüfen Sie Einheit, Reihenfolge der Drehungen (Z, dann Y, dann X des Stators), Zeitbasis und die Anordnung der Sensoren.</translation>
    </message>
    <message>
        <source>all readings have the opposite sign of those that {}.alpha, .beta and .gamma tell: their sign, or that of q, is reversed</source>
        <translation>Alle Messwerte haben das entgegengesetzte Vorzeichen derer zu {}.alpha, .beta und .gamma: Ihr Vorzeichen oder das von q ist umgekehrt</translation>
    </message>
    <message>
        <source>Sensor {} lies inside the rotor: {} mm from its centre, the rotor has {} mm.</source>
        <translation>Sensor {} liegt im Rotor: {} mm von dessen Mitte, der Rotor hat {} mm.</translation>
    </message>
    <message>
        <source>Sensors {} and {} lie at the same place.</source>
        <translation>Die Sensoren {} und {} liegen am selben Ort.</translation>
    </message>
    <message>
        <source>{}: {}: needs axis, position_unit and effort_unit</source>
        <translation>{}: {}: braucht axis, position_unit und effort_unit</translation>
    </message>
    <message>
        <source>{}: {}: gains: needs kp, ki, kd and filter_s</source>
        <translation>{}: {}: gains: braucht kp, ki, kd und filter_s</translation>
    </message>
    <message>
        <source>{}: sample_period_s, delay_samples: must be numbers, the first above zero</source>
        <translation>{}: sample_period_s, delay_samples: müssen Zahlen sein, die erste über null</translation>
    </message>
    <message>
        <source>{}: axes: the list is empty</source>
        <translation>{}: axes: Die Liste ist leer</translation>
    </message>
    <message>
        <source>{}: points[{}]: needs a frequency above the previous one and below half the rate</source>
        <translation>{}: points[{}]: braucht eine Frequenz über der vorigen und unter der halben Rate</translation>
    </message>
    <message>
        <source>{}: points[{}]: needs loops, used and coherence of each axis</source>
        <translation>{}: points[{}]: braucht loops, used und coherence jeder Achse</translation>
    </message>
    <message>
        <source>measure the response of a device with several axes</source>
        <translation>messen Sie den Frequenzgang eines Geräts mit mehreren Achsen</translation>
    </message>
    <message>
        <source>axis {}: the response is in {}/({}), the model in {}/({})</source>
        <translation>Achse {}: Der Frequenzgang ist in {}/({}), das Modell in {}/({})</translation>
    </message>
    <message>
        <source>measure the response on this kind of device</source>
        <translation>messen Sie den Frequenzgang an einem Gerät dieser Art</translation>
    </message>
    <message>
        <source>the response is of axes {}, the model has {}</source>
        <translation>der Frequenzgang ist von den Achsen {}, das Modell hat {}</translation>
    </message>
    <message>
        <source>open the response of an axis of the model</source>
        <translation>öffnen Sie den Frequenzgang einer Achse des Modells</translation>
    </message>
    <message>
        <source>no axes were identified</source>
        <translation>keine Achsen wurden identifiziert</translation>
    </message>
    <message>
        <source>identify the axes first</source>
        <translation>identifizieren Sie zuerst die Achsen</translation>
    </message>
    <message>
        <source>the response is of a device &apos;{}&apos;, the model is of a &apos;{}&apos;</source>
        <translation>der Frequenzgang ist von einem Gerät „{}“, das Modell von „{}“</translation>
    </message>
    <message>
        <source>open a response of this kind of device</source>
        <translation>öffnen Sie einen Frequenzgang dieser Art von Gerät</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number ({})</source>
        <translation>&apos;{}&apos; ist keine Zahl ({})</translation>
    </message>
    <message>
        <source>write a number, or leave the cell empty where a value is missing; remove a column of words; or set the format with --separator, --decimal and --header</source>
        <translation>schreiben Sie eine Zahl, oder lassen Sie die Zelle leer, wo ein Wert fehlt; entfernen Sie eine Spalte mit Wörtern; oder geben Sie das Format mit --separator, --decimal und --header an</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number (column {}, &apos;{}&apos;)</source>
        <translation>&apos;{}&apos; ist keine Zahl (Spalte {}, &apos;{}&apos;)</translation>
    </message>
    <message>
        <source>write numbers like -1{}5e-3, leave the cell empty where a value is missing, or set --decimal</source>
        <translation>schreiben Sie Zahlen wie -1{}5e-3, lassen Sie die Zelle leer, wo ein Wert fehlt, oder geben Sie --decimal an</translation>
    </message>
    <message>
        <source>the time is missing (column {}, &apos;{}&apos;)</source>
        <translation>die Zeit fehlt (Spalte {}, &apos;{}&apos;)</translation>
    </message>
    <message>
        <source>line {}, column {}, &apos;{}&apos;</source>
        <translation>Zeile {}, Spalte {}, &apos;{}&apos;</translation>
    </message>
    <message>
        <source>is {}, must be a whole number not below {}</source>
        <translation>ist {}, muss eine ganze Zahl nicht unter {} sein</translation>
    </message>
    <message>
        <source>is {}, must be a whole number from {} to {}</source>
        <translation>ist {}, muss eine ganze Zahl von {} bis {} sein</translation>
    </message>
    <message>
        <source>is {}, must be from {} to {}</source>
        <translation>ist {}, muss zwischen {} und {} liegen</translation>
    </message>
    <message>
        <source>is {}, must be above {}</source>
        <translation>ist {}, muss über {} liegen</translation>
    </message>
    <message>
        <source>is {}, must not be below {}</source>
        <translation>ist {}, darf nicht unter {} liegen</translation>
    </message>
    <message>
        <source>correct the value or write the file again</source>
        <translation>berichtigen Sie den Wert, oder schreiben Sie die Datei neu</translation>
    </message>
    <message>
        <source>is {}, no variance is negative</source>
        <translation>ist {}, keine Varianz ist negativ</translation>
    </message>
    <message>
        <source>is {} and [{}][{}] {}: must be equal</source>
        <translation>ist {} und [{}][{}] {}: müssen gleich sein</translation>
    </message>
    <message>
        <source>is {}, a correlation beyond 1: at most {}</source>
        <translation>ist {}, eine Korrelation über 1: höchstens {}</translation>
    </message>
    <message>
        <source>cells without a number: {}, the first in {}</source>
        <translation>Zellen ohne Zahl: {}, die erste in {}</translation>
    </message>
    <message>
        <source>they are missing values of the recording; enter them in the table where they are known</source>
        <translation>sie sind fehlende Werte der Aufzeichnung; tragen Sie sie in die Tabelle ein, wo sie bekannt sind</translation>
    </message>
    <message>
        <source>is {}, must be below {}, half of the sampling rate</source>
        <translation>ist {}, muss unter {} liegen, der halben Abtastrate</translation>
    </message>
    <message>
        <source>{} has no value at {} s (row {}, {} such rows)</source>
        <translation>{} hat bei {} s keinen Wert (Zeile {} der Daten, {} solche Zeilen)</translation>
    </message>
    <message>
        <source>remove these rows (the first is line {} of a CSV file) or enter their values</source>
        <translation>entfernen Sie diese Zeilen (die erste ist Zeile {} einer CSV-Datei), oder tragen Sie ihre Werte ein</translation>
    </message>
    <message>
        <source>the gains are for a sampling period of {} s, this device has {} s</source>
        <translation>die Reglerparameter sind für eine Abtastperiode von {} s, dieses Gerät hat {} s</translation>
    </message>
    <message>
        <source>turns straight</source>
        <translation>dreht sich gerade</translation>
    </message>
    <message>
        <source>measure the frequency response of its axes instead (identify --frequency)</source>
        <translation>stattdessen den Frequenzgang seiner Achsen messen (identify --frequency)</translation>
    </message>
    <message>
        <source>use fewer signals or a lower rate; with udp:, connect by tcp: instead</source>
        <translation>weniger Signale oder kleinere Rate verwenden; bei udp: stattdessen über tcp: verbinden</translation>
    </message>
    <message>
        <source>compare the current that flows with the commanded one, since a gain error of the drive contradicts so; then give only the best-known constant</source>
        <translation>den fließenden Strom mit dem befohlenen vergleichen, denn ein Verstärkungsfehler des Antriebs widerspricht so; dann nur die am besten bekannte Konstante angeben</translation>
    </message>
    <message>
        <source>a sweep of currents, directions, current tolerance or added inertia are for a motor</source>
        <translation>ein Durchlauf von Strömen, Richtungen, eine Stromtoleranz oder eine Zusatzträgheit sind für einen Motor</translation>
    </message>
    <message>
        <source>the current is taken as commanded within 0.3 %: a gain error of the drive moves phi, or J, c and K_f where phi is given, by as much and shows in no recording</source>
        <translation>der Strom gilt als der befohlene auf 0,3 %: ein Verstärkungsfehler des Antriebs verschiebt phi, oder J, c und K_f bei gegebenem phi, um ebenso viel und zeigt sich in keiner Aufzeichnung</translation>
    </message>
    <message>
        <source>the current is taken as commanded within {} %, as stated: the intervals include a gain error of the drive up to that; a larger one shows in no recording</source>
        <translation>der Strom gilt wie angegeben als der befohlene auf {} %: die Intervalle enthalten einen Verstärkungsfehler des Antriebs bis dahin; ein größerer zeigt sich in keiner Aufzeichnung</translation>
    </message>
    <message>
        <source>state how well the current is known (--current-tolerance-percent), compare the current that flows with the commanded one, or give both J and phi: the program then finds a contradiction</source>
        <translation>angeben, wie gut der Strom bekannt ist (--current-tolerance-percent), den fließenden Strom mit dem befohlenen vergleichen, oder J und phi beide angeben: das Programm findet dann einen Widerspruch</translation>
    </message>
    <message>
        <source>the current tolerance is not a finite number</source>
        <translation>die Stromtoleranz ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>give it in per cent, e.g. 3</source>
        <translation>sie in Prozent angeben, z. B. 3</translation>
    </message>
    <message>
        <source>a current tolerance of {} % is not possible</source>
        <translation>eine Stromtoleranz von {} % ist nicht möglich</translation>
    </message>
    <message>
        <source>give 0 to 50 %</source>
        <translation>0 bis 50 % angeben</translation>
    </message>
    <message>
        <source>the rotor came near standstill: measured with {} of the planned amplitude</source>
        <translation>der Rotor kam dem Stillstand nahe: gemessen mit dem {}-Fachen der geplanten Amplitude</translation>
    </message>
    <message>
        <source>choose a higher base speed for a larger amplitude</source>
        <translation>für eine größere Amplitude eine höhere Grunddrehzahl wählen</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Of the circle, whose centre lies so far in the direction of x, or of the arc</source>
        <translation>Des Kreises, dessen Mittelpunkt so weit in Richtung x liegt, oder des Bogens</translation>
    </message>
    <message>
        <source>Of the arc, counter-clockwise</source>
        <translation>Des Bogens, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Direction in which arc and line begin, from x towards y</source>
        <translation>Richtung, in der Bogen und Strecke beginnen, von x nach y</translation>
    </message>
    <message>
        <source>Of the line</source>
        <translation>Der Strecke</translation>
    </message>
    <message>
        <source>the heading of a path is not a number</source>
        <translation>die Anfangsrichtung einer Bahn ist keine Zahl</translation>
    </message>
    <message>
        <source>Give a finite angle.</source>
        <translation>Einen endlichen Winkel angeben.</translation>
    </message>
    <message>
        <source>noise and drawn errors of this specimen</source>
        <translation>Rauschen und gezogene Fehler dieses Exemplars</translation>
    </message>
    <message>
        <source>noise, sensor errors and spread</source>
        <translation>Rauschen, Sensorfehler und Streuung</translation>
    </message>
    <message>
        <source>converters and amplifiers, or exact values</source>
        <translation>Wandler und Verstärker, oder genaue Werte</translation>
    </message>
    <message>
        <source>motion: CSV file of poses</source>
        <translation>Bewegung: CSV-Datei der Lagen</translation>
    </message>
    <message>
        <source>rotor inertia</source>
        <translation>Trägheitsmoment des Rotors</translation>
    </message>
    <message>
        <source>torque per ampere of current amplitude</source>
        <translation>Drehmoment je Ampere Stromamplitude</translation>
    </message>
    <message>
        <source>current amplitude limit</source>
        <translation>Grenze der Stromamplitude</translation>
    </message>
    <message>
        <source>field amplitude at the Hall sensors</source>
        <translation>Feldamplitude an den Hall-Sensoren</translation>
    </message>
    <message>
        <source>resistance of one phase</source>
        <translation>Widerstand einer Phase</translation>
    </message>
    <message>
        <source>inductance of one phase</source>
        <translation>Induktivität einer Phase</translation>
    </message>
    <message>
        <source>rotor angle at the start</source>
        <translation>Rotorwinkel zu Beginn</translation>
    </message>
    <message>
        <source>amplifier resistor R{}</source>
        <translation>Verstärkerwiderstand R{}</translation>
    </message>
    <message>
        <source>amplifier current shunt</source>
        <translation>Messwiderstand des Verstärkers</translation>
    </message>
    <message>
        <source>amplifier capacitor C{}</source>
        <translation>Verstärkerkondensator C{}</translation>
    </message>
    <message>
        <source>Hall sensitivity at 25 degC</source>
        <translation>Hall-Empfindlichkeit bei 25 °C</translation>
    </message>
    <message>
        <source>temperature coefficient of the Hall sensitivity</source>
        <translation>Temperaturkoeffizient der Hall-Empfindlichkeit</translation>
    </message>
    <message>
        <source>Hall output at zero field</source>
        <translation>Hall-Ausgang ohne Feld</translation>
    </message>
    <message>
        <source>field of a phase at its own sensor</source>
        <translation>Feld einer Phase am eigenen Sensor</translation>
    </message>
    <message>
        <source>computation delay of the position loop</source>
        <translation>Rechentotzeit des Lageregelkreises</translation>
    </message>
    <message>
        <source>relative run-to-run friction scatter, 1 sigma</source>
        <translation>relative Reibungsstreuung von Lauf zu Lauf, 1 sigma</translation>
    </message>
    <message>
        <source>relative once-per-turn friction, amplitude</source>
        <translation>relative Reibung einmal je Umdrehung, Amplitude</translation>
    </message>
    <message>
        <source>static over kinetic friction</source>
        <translation>Haft- zu Gleitreibung</translation>
    </message>
    <message>
        <source>speed at which static friction fades</source>
        <translation>Drehzahl, bei der die Haftreibung abklingt</translation>
    </message>
    <message>
        <source>Hall noise per sample, rms</source>
        <translation>Hall-Rauschen je Abtastung, Effektivwert</translation>
    </message>
    <message>
        <source>zero offset of both sensors; drawn for each if not given</source>
        <translation>Nullpunktfehler beider Sensoren; ohne Angabe je Sensor gezogen</translation>
    </message>
    <message>
        <source>spread of the drawn offsets, 1 sigma</source>
        <translation>Streuung der gezogenen Nullpunktfehler, 1 sigma</translation>
    </message>
    <message>
        <source>gain of sensor a over sensor b, minus one; drawn for each if not given</source>
        <translation>Verstärkung von Sensor a zu Sensor b, minus eins; ohne Angabe je Sensor gezogen</translation>
    </message>
    <message>
        <source>spread of the drawn gains, 1 sigma</source>
        <translation>Streuung der gezogenen Verstärkungen, 1 sigma</translation>
    </message>
    <message>
        <source>spread of the drawn linearity errors</source>
        <translation>Streuung der gezogenen Linearitätsfehler</translation>
    </message>
    <message>
        <source>angle error between the sensors; drawn if not given</source>
        <translation>Winkelfehler zwischen den Sensoren; ohne Angabe gezogen</translation>
    </message>
    <message>
        <source>spread of the drawn angle error</source>
        <translation>Streuung des gezogenen Winkelfehlers</translation>
    </message>
    <message>
        <source>spread of the sensors&apos; radius</source>
        <translation>Streuung des Sensorradius</translation>
    </message>
    <message>
        <source>remanence scatter of the bars, 1 sigma; their angle scatter goes with it (0.02: 1 deg)</source>
        <translation>Remanenzstreuung der Stäbe, 1 sigma; ihre Winkelstreuung geht mit (0,02: 1 Grad)</translation>
    </message>
    <message>
        <source>temperature coefficient of field and torque</source>
        <translation>Temperaturkoeffizient von Feld und Drehmoment</translation>
    </message>
    <message>
        <source>ambient temperature</source>
        <translation>Umgebungstemperatur</translation>
    </message>
    <message>
        <source>share of the coil&apos;s rise at its sensor</source>
        <translation>Anteil der Spulenerwärmung am Sensor</translation>
    </message>
    <message>
        <source>error of both temperature sensors; drawn for each if not given</source>
        <translation>Fehler beider Temperatursensoren; ohne Angabe je Sensor gezogen</translation>
    </message>
    <message>
        <source>spread of the drawn temperature errors</source>
        <translation>Streuung der gezogenen Temperaturfehler</translation>
    </message>
    <message>
        <source>heat capacity of one phase</source>
        <translation>Wärmekapazität einer Phase</translation>
    </message>
    <message>
        <source>from one phase to ambient</source>
        <translation>von einer Phase zur Umgebung</translation>
    </message>
    <message>
        <source>temperature coefficient of the resistance</source>
        <translation>Temperaturkoeffizient des Widerstands</translation>
    </message>
    <message>
        <source>thermal seconds per second; 0: no heating</source>
        <translation>thermische Sekunden je Sekunde; 0: keine Erwärmung</translation>
    </message>
    <message>
        <source>gain error of both outputs; drawn if not given</source>
        <translation>Verstärkungsfehler beider Ausgänge; ohne Angabe gezogen</translation>
    </message>
    <message>
        <source>spread of the drawn gain errors, 1 sigma</source>
        <translation>Streuung der gezogenen Verstärkungsfehler, 1 sigma</translation>
    </message>
    <message>
        <source>integral non-linearity of both outputs; drawn if not given</source>
        <translation>integrale Nichtlinearität beider Ausgänge; ohne Angabe gezogen</translation>
    </message>
    <message>
        <source>largest drawn non-linearity</source>
        <translation>größte gezogene Nichtlinearität</translation>
    </message>
    <message>
        <source>{}&apos; gain error of chip {}; drawn if not given</source>
        <translation>Verstärkungsfehler {}&apos; von Chip {}; ohne Angabe gezogen</translation>
    </message>
    <message>
        <source>{}&apos; zero offset of chip {}; drawn if not given</source>
        <translation>Nullpunktfehler {}&apos; von Chip {}; ohne Angabe gezogen</translation>
    </message>
    <message>
        <source>share of {}&apos; in {}&apos; of chip {}; drawn if not given</source>
        <translation>Anteil von {}&apos; in {}&apos; von Chip {}; ohne Angabe gezogen</translation>
    </message>
    <message>
        <source>{}&apos; place error of chip {}; drawn if not given</source>
        <translation>Ortsfehler {}&apos; von Chip {}; ohne Angabe gezogen</translation>
    </message>
    <message>
        <source>height error of chip {}; drawn if not given</source>
        <translation>Höhenfehler von Chip {}; ohne Angabe gezogen</translation>
    </message>
    <message>
        <source>real centre of mass along {}&apos;</source>
        <translation>wahrer Schwerpunkt entlang {}&apos;</translation>
    </message>
    <message>
        <source>rotation at the start</source>
        <translation>Drehung zu Beginn</translation>
    </message>
    <message>
        <source>pitch of the magnet matrix</source>
        <translation>Teilung der Magnetmatrix</translation>
    </message>
    <message>
        <source>height of the magnet blocks</source>
        <translation>Höhe der Magnetblöcke</translation>
    </message>
    <message>
        <source>peak magnetisation of one array</source>
        <translation>Spitzenmagnetisierung eines Arrays</translation>
    </message>
    <message>
        <source>edge of the magnet matrix in pitches</source>
        <translation>Kantenlänge der Magnetmatrix in Teilungen</translation>
    </message>
    <message>
        <source>width of a coil&apos;s winding</source>
        <translation>Breite einer Spulenwicklung</translation>
    </message>
    <message>
        <source>height of a coil&apos;s winding</source>
        <translation>Höhe einer Spulenwicklung</translation>
    </message>
    <message>
        <source>turns per width</source>
        <translation>Windungen je Breite</translation>
    </message>
    <message>
        <source>layers per height</source>
        <translation>Lagen je Höhe</translation>
    </message>
    <message>
        <source>gap from the magnets to the coils</source>
        <translation>Spalt zwischen Magneten und Spulen</translation>
    </message>
    <message>
        <source>arm of coils 5 and 6</source>
        <translation>Hebelarm der Spulen 5 und 6</translation>
    </message>
    <message>
        <source>resistance of a coil</source>
        <translation>Widerstand einer Spule</translation>
    </message>
    <message>
        <source>inductance of a coil</source>
        <translation>Induktivität einer Spule</translation>
    </message>
    <message>
        <source>current limit of a coil</source>
        <translation>Stromgrenze einer Spule</translation>
    </message>
    <message>
        <source>force of coil {} over its nominal one</source>
        <translation>Kraft der Spule {} zu ihrer Nennkraft</translation>
    </message>
    <message>
        <source>current per volt of an amplifier</source>
        <translation>Strom je Volt eines Verstärkers</translation>
    </message>
    <message>
        <source>bandwidth of an amplifier</source>
        <translation>Bandbreite eines Verstärkers</translation>
    </message>
    <message>
        <source>largest voltage at a coil</source>
        <translation>größte Spannung an einer Spule</translation>
    </message>
    <message>
        <source>output resistance of an amplifier</source>
        <translation>Ausgangswiderstand eines Verstärkers</translation>
    </message>
    <message>
        <source>resolution of the outputs</source>
        <translation>Auflösung der Ausgänge</translation>
    </message>
    <message>
        <source>range of the outputs, plus and minus</source>
        <translation>Bereich der Ausgänge, plus und minus</translation>
    </message>
    <message>
        <source>in-plane field amplitude at the chips</source>
        <translation>Feldamplitude in der Ebene an den Chips</translation>
    </message>
    <message>
        <source>place of chip {} along {}&apos;</source>
        <translation>Ort von Chip {} entlang {}&apos;</translation>
    </message>
    <message>
        <source>Hall noise per reading, rms</source>
        <translation>Hall-Rauschen je Messwert, Effektivwert</translation>
    </message>
    <message>
        <source>field at which a chip clips</source>
        <translation>Feld, bei dem ein Chip begrenzt</translation>
    </message>
    <message>
        <source>sensitivity after conditioning</source>
        <translation>Empfindlichkeit nach der Aufbereitung</translation>
    </message>
    <message>
        <source>resolution of the inputs</source>
        <translation>Auflösung der Eingänge</translation>
    </message>
    <message>
        <source>range of the inputs, plus and minus</source>
        <translation>Bereich der Eingänge, plus und minus</translation>
    </message>
    <message>
        <source>field of the coils at the chips over the calculated one</source>
        <translation>Feld der Spulen an den Chips zum berechneten</translation>
    </message>
    <message>
        <source>spread of the drawn cross-axis shares</source>
        <translation>Streuung der gezogenen Queranteile</translation>
    </message>
    <message>
        <source>spread of the drawn places</source>
        <translation>Streuung der gezogenen Orte</translation>
    </message>
    <message>
        <source>spread of the drawn heights</source>
        <translation>Streuung der gezogenen Höhen</translation>
    </message>
    <message>
        <source>stiffness of the cable</source>
        <translation>Steifigkeit des Kabels</translation>
    </message>
    <message>
        <source>torsion of the cable</source>
        <translation>Torsionssteifigkeit des Kabels</translation>
    </message>
    <message>
        <source>anchor of the cable along {}&apos;</source>
        <translation>Befestigung des Kabels entlang {}&apos;</translation>
    </message>
    <message>
        <source>slow random force per axis, rms</source>
        <translation>langsame Zufallskraft je Achse, Effektivwert</translation>
    </message>
    <message>
        <source>corner of the slow random force</source>
        <translation>Eckfrequenz der langsamen Zufallskraft</translation>
    </message>
    <message>
        <source>damping of the motion in the plane</source>
        <translation>Dämpfung der Bewegung in der Ebene</translation>
    </message>
    <message>
        <source>damping of the rotation</source>
        <translation>Dämpfung der Drehung</translation>
    </message>
    <message>
        <source>travel from the middle to a stop</source>
        <translation>Weg von der Mitte bis zum Anschlag</translation>
    </message>
    <message>
        <source>rotation from the middle to a stop</source>
        <translation>Drehung von der Mitte bis zum Anschlag</translation>
    </message>
    <message>
        <source>stiffness of the stops</source>
        <translation>Steifigkeit der Anschläge</translation>
    </message>
    <message>
        <source>stiffness of the stops in angle</source>
        <translation>Drehsteifigkeit der Anschläge</translation>
    </message>
    <message>
        <source>damping of the stops over the critical one</source>
        <translation>Dämpfung der Anschläge zur kritischen</translation>
    </message>
    <message>
        <source>stiffness of each air bearing</source>
        <translation>Steifigkeit jedes Luftlagers</translation>
    </message>
    <message>
        <source>heat capacity of a coil</source>
        <translation>Wärmekapazität einer Spule</translation>
    </message>
    <message>
        <source>from a coil to ambient</source>
        <translation>von einer Spule zur Umgebung</translation>
    </message>
    <message>
        <source>error of the temperature sensors; drawn for each if not given</source>
        <translation>Fehler der Temperatursensoren; ohne Angabe je Sensor gezogen</translation>
    </message>
    <message>
        <source>gain error of sensor {} along {}; drawn</source>
        <translation>Verstärkungsfehler von Sensor {} entlang {}; gezogen</translation>
    </message>
    <message>
        <source>offset of sensor {} along {}; drawn</source>
        <translation>Nullpunktfehler von Sensor {} entlang {}; gezogen</translation>
    </message>
    <message>
        <source>mounting error of sensor {} about stator {}; drawn</source>
        <translation>Einbaufehler von Sensor {} um Stator {}; gezogen</translation>
    </message>
    <message>
        <source>place error of sensor {} along stator {}; drawn</source>
        <translation>Ortsfehler von Sensor {} entlang Stator {}; gezogen</translation>
    </message>
    <message>
        <source>placement of sensor {} about {}</source>
        <translation>Anordnung von Sensor {} um {}</translation>
    </message>
    <message>
        <source>outer radius of the rotor</source>
        <translation>Außenradius des Rotors</translation>
    </message>
    <message>
        <source>radius of the rotor&apos;s core</source>
        <translation>Radius des Rotorkerns</translation>
    </message>
    <message>
        <source>pole angle of the magnet</source>
        <translation>Polwinkel des Magneten</translation>
    </message>
    <message>
        <source>remanence</source>
        <translation>Remanenz</translation>
    </message>
    <message>
        <source>relative recoil permeability</source>
        <translation>relative permanente Permeabilität</translation>
    </message>
    <message>
        <source>relative permeability of the core</source>
        <translation>relative Permeabilität des Kerns</translation>
    </message>
    <message>
        <source>azimuthal coefficient</source>
        <translation>azimutaler Koeffizient</translation>
    </message>
    <message>
        <source>distance of the sensors from the centre</source>
        <translation>Abstand der Sensoren vom Mittelpunkt</translation>
    </message>
    <message>
        <source>harmonic ({}) at 50 mm instead of the preset&apos;s</source>
        <translation>Harmonische ({}) bei 50 mm statt der des Parametersatzes</translation>
    </message>
    <message>
        <source>spread of the drawn cross-axis shares, 1 sigma</source>
        <translation>Streuung der gezogenen Queranteile, 1 sigma</translation>
    </message>
    <message>
        <source>spread of the drawn mounting angles, 1 sigma</source>
        <translation>Streuung der gezogenen Einbauwinkel, 1 sigma</translation>
    </message>
    <message>
        <source>spread of the drawn places, 1 sigma</source>
        <translation>Streuung der gezogenen Orte, 1 sigma</translation>
    </message>
    <message>
        <source>noise of a reading, rms</source>
        <translation>Rauschen eines Messwerts, Effektivwert</translation>
    </message>
    <message>
        <source>uniform stray field along {}</source>
        <translation>gleichförmiges Streufeld entlang {}</translation>
    </message>
    <message>
        <source>place of the stator coil, from {}</source>
        <translation>Ort der Statorspule, von {} aus</translation>
    </message>
    <message>
        <source>distance of the coil&apos;s centre</source>
        <translation>Abstand der Spulenmitte</translation>
    </message>
    <message>
        <source>radius of the stator coil</source>
        <translation>Radius der Statorspule</translation>
    </message>
    <message>
        <source>turns of the stator coil</source>
        <translation>Windungen der Statorspule</translation>
    </message>
    <message>
        <source>current of the stator coil</source>
        <translation>Strom der Statorspule</translation>
    </message>
    <message>
        <source>temperature at the start</source>
        <translation>Temperatur zu Beginn</translation>
    </message>
    <message>
        <source>final rise of the magnet</source>
        <translation>Enderwärmung des Magneten</translation>
    </message>
    <message>
        <source>time constant of the rise</source>
        <translation>Zeitkonstante der Erwärmung</translation>
    </message>
    <message>
        <source>relative change of the field with temperature</source>
        <translation>relative Änderung des Felds mit der Temperatur</translation>
    </message>
    <message>
        <source>error of the temperature sensor; drawn</source>
        <translation>Fehler des Temperatursensors; gezogen</translation>
    </message>
    <message>
        <source>spread of the drawn temperature errors, 1 sigma</source>
        <translation>Streuung der gezogenen Temperaturfehler, 1 sigma</translation>
    </message>
    <message>
        <source>start, rotation about {}</source>
        <translation>Beginn, Drehung um {}</translation>
    </message>
    <message>
        <source>start, spin about the shaft</source>
        <translation>Beginn, Drehung um die Welle</translation>
    </message>
    <message>
        <source>rate towards a set-point, spin of tumbling</source>
        <translation>Drehrate zum Sollwert, Eigendrehung beim Taumeln</translation>
    </message>
    <message>
        <source>spin along the published trajectories</source>
        <translation>Eigendrehung entlang der veröffentlichten Bahnen</translation>
    </message>
    <message>
        <source>time between two published samples</source>
        <translation>Zeit zwischen zwei veröffentlichten Punkten</translation>
    </message>
    <message>
        <source>tilt of tumbling, limit of the random walk</source>
        <translation>Neigung beim Taumeln, Grenze der Irrfahrt</translation>
    </message>
    <message>
        <source>frequency of tumbling about {}</source>
        <translation>Taumelfrequenz um {}</translation>
    </message>
    <message>
        <source>random walk: rms of an axis after one second</source>
        <translation>Irrfahrt: Effektivwert einer Achse nach einer Sekunde</translation>
    </message>
    <message>
        <source>x at the start</source>
        <translation>x zu Beginn</translation>
    </message>
    <message>
        <source>y at the start</source>
        <translation>y zu Beginn</translation>
    </message>
    <message>
        <source>asymmetry of friction, (Kf+ - Kf-)/(Kf+ + Kf-)</source>
        <translation>Asymmetrie der Reibung, (Kf+ - Kf-)/(Kf+ + Kf-)</translation>
    </message>
    <message>
        <source>Viscous damping</source>
        <translation>Viskose Dämpfung</translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation>Drehmomentkonstante</translation>
    </message>
    <message>
        <source>the radius of an arc is negative</source>
        <translation>der Radius eines Bogens ist negativ</translation>
    </message>
    <message>
        <source>Its angle says to which side it bends.</source>
        <translation>Sein Winkel sagt, nach welcher Seite er sich biegt.</translation>
    </message>
    <message>
        <source>{}={} has a character that divides an address</source>
        <translation>{}={} enthält ein Trennzeichen der Adresse</translation>
    </message>
    <message>
        <source>Leave out &amp; ? #.</source>
        <translation>&amp; ? # weglassen.</translation>
    </message>
    <message>
        <source>a {} has no {}</source>
        <translation>zu {} gehört kein {}</translation>
    </message>
    <message>
        <source>the radius of an arc is positive</source>
        <translation>der Radius eines Bogens ist positiv</translation>
    </message>
    <message>
        <source>The sign of angle_deg says whether it bends to the left (positive) or to the right.</source>
        <translation>Das Vorzeichen von angle_deg sagt, ob er sich nach links (positiv) oder rechts biegt.</translation>
    </message>
    <message>
        <source>check the value and the board&apos;s state</source>
        <translation>den Wert und den Zustand des Boards prüfen</translation>
    </message>
    <message>
        <source>the line has lost or damaged packets (so far {}): check the line, then the value and the board&apos;s state</source>
        <translation>die Leitung hat Pakete verloren oder beschädigt (bisher {}): die Leitung prüfen, dann den Wert und den Zustand des Boards</translation>
    </message>
    <message>
        <source>the connection was lost once and came back</source>
        <translation>die Verbindung ging einmal verloren und kam wieder</translation>
    </message>
    <message>
        <source>the connection was lost {} times and came back</source>
        <translation>die Verbindung ging {}-mal verloren und kam wieder</translation>
    </message>
    <message>
        <source>check the cable, the plug and the power of the device</source>
        <translation>Kabel, Stecker und Versorgung des Geräts prüfen</translation>
    </message>
    <message>
        <source>the sample recording &apos;{}&apos; cannot be read</source>
        <translation>die Beispielaufzeichnung &apos;{}&apos; lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>install the program again</source>
        <translation>installieren Sie das Programm neu</translation>
    </message>
    <message>
        <source>the sample recording cannot be copied to &apos;{}&apos;: {}</source>
        <translation>die Beispielaufzeichnung lässt sich nicht nach &apos;{}&apos; kopieren: {}</translation>
    </message>
    <message>
        <source>Path that x and y (of a table all axes) follow from the next start on, once, instead of references</source>
        <translation>Bahn, der x und y (bei einer Tabelle alle Achsen) ab dem nächsten Start einmal folgen, anstelle der Führungsgrößen</translation>
    </message>
    <message>
        <source>Where a piece begins, from where the motion began</source>
        <translation>Wo ein Stück beginnt, gezählt vom Beginn der Bewegung</translation>
    </message>
    <message>
        <source>At the beginning of the piece</source>
        <translation>Am Anfang des Stücks</translation>
    </message>
    <message>
        <source>During the piece</source>
        <translation>Während des Stücks</translation>
    </message>
    <message>
        <source>How long the piece lasts</source>
        <translation>Dauer des Stücks</translation>
    </message>
    <message>
        <source>Writing n stores the piece as number n of the table</source>
        <translation>n schreiben speichert das Stück als Nummer n der Tabelle</translation>
    </message>
    <message>
        <source>Pieces that path.shape = table follows</source>
        <translation>Stücke, denen path.shape = table folgt</translation>
    </message>
    <message>
        <source>a motion without poses</source>
        <translation>eine Bewegung ohne Lagen</translation>
    </message>
    <message>
        <source>Give at least one pose.</source>
        <translation>Mindestens eine Lage angeben.</translation>
    </message>
    <message>
        <source>poses with different numbers of axes</source>
        <translation>Lagen mit verschieden vielen Achsen</translation>
    </message>
    <message>
        <source>Give every axis in every row.</source>
        <translation>In jeder Zeile jede Achse angeben.</translation>
    </message>
    <message>
        <source>a pose is not a number</source>
        <translation>eine Lage ist keine Zahl</translation>
    </message>
    <message>
        <source>Give finite poses.</source>
        <translation>Endliche Lagen angeben.</translation>
    </message>
    <message>
        <source>the poses move nothing</source>
        <translation>die Lagen bewegen nichts</translation>
    </message>
    <message>
        <source>Poses count from where the axes stand: give one that differs from 0.</source>
        <translation>Lagen zählen vom Stand der Achsen: eine angeben, die nicht 0 ist.</translation>
    </message>
    <message>
        <source>not as many times as poses</source>
        <translation>nicht so viele Zeiten wie Lagen</translation>
    </message>
    <message>
        <source>Give a time for every pose.</source>
        <translation>Für jede Lage eine Zeit angeben.</translation>
    </message>
    <message>
        <source>a time of a pose is not a number</source>
        <translation>die Zeit einer Lage ist keine Zahl</translation>
    </message>
    <message>
        <source>Give finite times.</source>
        <translation>Endliche Zeiten angeben.</translation>
    </message>
    <message>
        <source>the times of poses do not increase</source>
        <translation>die Zeiten der Lagen nehmen nicht zu</translation>
    </message>
    <message>
        <source>Sort the rows; times begin at 0 or later.</source>
        <translation>Zeilen sortieren; Zeiten beginnen bei 0 oder später.</translation>
    </message>
    <message>
        <source>at time 0 the pose is not 0</source>
        <translation>zur Zeit 0 ist die Lage nicht 0</translation>
    </message>
    <message>
        <source>Poses count from where the axes stand when they start: begin with zeros, or later.</source>
        <translation>Lagen zählen vom Stand der Achsen beim Start: mit Nullen beginnen, oder später.</translation>
    </message>
    <message>
        <source>radius; of a circle the centre lies along the first axis</source>
        <translation>Radius; bei einem Kreis liegt die Mitte entlang der ersten Achse</translation>
    </message>
    <message>
        <source>turns of a circle</source>
        <translation>Umläufe eines Kreises</translation>
    </message>
    <message>
        <source>length of the lines of a raster, along the first axis</source>
        <translation>Länge der Zeilen eines Rasters, entlang der ersten Achse</translation>
    </message>
    <message>
        <source>from line to line of a raster, along the second axis</source>
        <translation>von Zeile zu Zeile eines Rasters, entlang der zweiten Achse</translation>
    </message>
    <message>
        <source>lines of a raster</source>
        <translation>Zeilen eines Rasters</translation>
    </message>
    <message>
        <source>angle of an arc, counter-clockwise</source>
        <translation>Winkel eines Bogens, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>start direction of arc and line, from first to second axis</source>
        <translation>Anfangsrichtung von Bogen und Strecke, von der ersten zur zweiten Achse</translation>
    </message>
    <message>
        <source>length of a line</source>
        <translation>Länge einer Strecke</translation>
    </message>
    <message>
        <source>rest in every row of a table without time_s</source>
        <translation>Halt in jeder Zeile einer Tabelle ohne time_s</translation>
    </message>
    <message>
        <source>a {} has no file</source>
        <translation>eine Form {} hat keine Datei</translation>
    </message>
    <message>
        <source>Only a table has a file of poses.</source>
        <translation>Nur eine Tabelle hat eine Datei mit Lagen.</translation>
    </message>
    <message>
        <source>Write a header like time_s,x_mm,y_mm,phi_mrad.</source>
        <translation>Eine Kopfzeile wie time_s,x_mm,y_mm,phi_mrad schreiben.</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; has no unit in its name</source>
        <translation>Spalte &apos;{}&apos; hat keine Einheit im Namen</translation>
    </message>
    <message>
        <source>column &apos;{}&apos;: &apos;{}&apos; is no unit of a {}</source>
        <translation>Spalte &apos;{}&apos;: &apos;{}&apos; ist keine Einheit für {}</translation>
    </message>
    <message>
        <source>length or an angle</source>
        <translation>Länge oder Winkel</translation>
    </message>
    <message>
        <source>Write time_s or time_ms.</source>
        <translation>time_s oder time_ms schreiben.</translation>
    </message>
    <message>
        <source>Write e.g. x_mm, x_m, phi_mrad or phi_deg.</source>
        <translation>Zum Beispiel x_mm, x_m, phi_mrad oder phi_deg schreiben.</translation>
    </message>
    <message>
        <source>At most {} are read.</source>
        <translation>Höchstens {} werden gelesen.</translation>
    </message>
    <message>
        <source>a quoted cell does not end</source>
        <translation>eine Zelle in Anführungszeichen endet nicht</translation>
    </message>
    <message>
        <source>Write numbers without quotes.</source>
        <translation>Zahlen ohne Anführungszeichen schreiben.</translation>
    </message>
    <message>
        <source>the time is given twice</source>
        <translation>die Zeit ist zweimal angegeben</translation>
    </message>
    <message>
        <source>axis {} is given twice, as {} and {}</source>
        <translation>Achse {} ist zweimal angegeben, als {} und {}</translation>
    </message>
    <message>
        <source>Keep one of the columns.</source>
        <translation>Eine der Spalten behalten.</translation>
    </message>
    <message>
        <source>the table has no column of an axis</source>
        <translation>die Tabelle hat keine Spalte für eine Achse</translation>
    </message>
    <message>
        <source>{} has no value</source>
        <translation>{} hat keinen Wert</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a finite number ({})</source>
        <translation>&apos;{}&apos; ist keine endliche Zahl ({})</translation>
    </message>
    <message>
        <source>Write numbers like -1{}5e-3 in every cell.</source>
        <translation>In jede Zelle eine Zahl wie -1{}5e-3 schreiben.</translation>
    </message>
    <message>
        <source>the time is negative</source>
        <translation>die Zeit ist negativ</translation>
    </message>
    <message>
        <source>Times count from the start of the motion.</source>
        <translation>Zeiten zählen vom Beginn der Bewegung.</translation>
    </message>
    <message>
        <source>time {} s comes after {} s</source>
        <translation>Zeit {} s kommt nach {} s</translation>
    </message>
    <message>
        <source>Sort the rows by time, each time once.</source>
        <translation>Zeilen nach der Zeit sortieren, jede Zeit einmal.</translation>
    </message>
    <message>
        <source>more than {} rows</source>
        <translation>mehr als {} Zeilen</translation>
    </message>
    <message>
        <source>Split the table.</source>
        <translation>Tabelle teilen.</translation>
    </message>
    <message>
        <source>{} cells, but the header has {} columns</source>
        <translation>{} Zellen, aber die Kopfzeile hat {} Spalten</translation>
    </message>
    <message>
        <source>Give every column a value; the separator is that of the header.</source>
        <translation>Jeder Spalte einen Wert geben; das Trennzeichen ist das der Kopfzeile.</translation>
    </message>
    <message>
        <source>the table has no rows</source>
        <translation>die Tabelle hat keine Zeilen</translation>
    </message>
    <message>
        <source>the table has one row only</source>
        <translation>die Tabelle hat nur eine Zeile</translation>
    </message>
    <message>
        <source>Give two poses or more, a line each. For one pose use a travel, e.g. s-curve.</source>
        <translation>Mindestens zwei Lagen angeben, je eine Zeile. Für eine Lage eine Fahrt verwenden, z. B. s-curve.</translation>
    </message>
    <message>
        <source>{}: the table has {} octets, {} are read</source>
        <translation>{}: die Tabelle hat {} Byte, {} werden gelesen</translation>
    </message>
    <message>
        <source>Split the table; {} rows are the most.</source>
        <translation>Tabelle teilen; höchstens {} Zeilen.</translation>
    </message>
    <message>
        <source>{}: the file is no text</source>
        <translation>{}: die Datei ist kein Text</translation>
    </message>
    <message>
        <source>without time_s the way to {} needs {}</source>
        <translation>ohne time_s braucht der Weg nach {} {}</translation>
    </message>
    <message>
        <source>Add {}=... to the reference, or a column time_s to the table.</source>
        <translation>{}=... zur Führungsgröße oder eine Spalte time_s zur Tabelle hinzufügen.</translation>
    </message>
    <message>
        <source>{}: row {}: axis {} {} {} {}{}, the limit is {} {}{} ({})</source>
        <translation>{}: Zeile {}: Achse {} {} {} {}{}, die Grenze ist {} {}{} ({})</translation>
    </message>
    <message>
        <source>Use poses nearer to the start, or a wider window. Nothing moved.</source>
        <translation>Lagen näher am Start oder ein weiteres Fenster verwenden. Es hat sich nichts bewegt.</translation>
    </message>
    <message>
        <source>Give the row more time, or bring it nearer to the one before. Nothing moved.</source>
        <translation>Der Zeile mehr Zeit geben, oder sie näher an die davor legen. Es hat sich nichts bewegt.</translation>
    </message>
    <message>
        <source>moves at</source>
        <translation>bewegt sich mit</translation>
    </message>
    <message>
        <source>rate of the reference</source>
        <translation>rate der Führungsgröße</translation>
    </message>
    <message>
        <source>accelerates at</source>
        <translation>beschleunigt mit</translation>
    </message>
    <message>
        <source>acceleration of the reference</source>
        <translation>acceleration der Führungsgröße</translation>
    </message>
    <message>
        <source>has a jerk of</source>
        <translation>hat einen Ruck von</translation>
    </message>
    <message>
        <source>jerk of the reference</source>
        <translation>jerk der Führungsgröße</translation>
    </message>
    <message>
        <source>dwell_s is for tables without time_s</source>
        <translation>dwell_s gilt für Tabellen ohne time_s</translation>
    </message>
    <message>
        <source>Leave it out: two rows with the same pose are a pause.</source>
        <translation>Weglassen: Zwei Zeilen mit derselben Lage sind eine Pause.</translation>
    </message>
    <message>
        <source>{}: the device has no axis &apos;{}&apos; ({})</source>
        <translation>{}: das Gerät hat keine Achse &apos;{}&apos; ({})</translation>
    </message>
    <message>
        <source>Its axes: {}.</source>
        <translation>Seine Achsen: {}.</translation>
    </message>
    <message>
        <source>{}: axis {} is in {}, not in {} ({})</source>
        <translation>{}: Achse {} ist in {}, nicht in {} ({})</translation>
    </message>
    <message>
        <source>Name the column {}_{}.</source>
        <translation>Die Spalte {}_{} nennen.</translation>
    </message>
    <message>
        <source>{}: the way takes {} pieces, the board has room for {}</source>
        <translation>{}: der Weg braucht {} Stücke, die Platine fasst {}</translation>
    </message>
    <message>
        <source>Split the table, or use fewer rows.</source>
        <translation>Tabelle teilen oder weniger Zeilen verwenden.</translation>
    </message>
    <message>
        <source>{}: row {}: the way takes {} s, the board takes up to {} s</source>
        <translation>{}: Zeile {}: der Weg dauert {} s, die Platine nimmt bis zu {} s</translation>
    </message>
    <message>
        <source>Add rows in between.</source>
        <translation>Zeilen dazwischen einfügen.</translation>
    </message>
    <message>
        <source>a table needs file</source>
        <translation>eine Tabelle braucht file</translation>
    </message>
    <message>
        <source>Add file=POSES.csv to the reference.</source>
        <translation>file=POSES.csv zur Führungsgröße hinzufügen.</translation>
    </message>
    <message>
        <source>a table has no amplitude and no constant motion</source>
        <translation>eine Tabelle hat keine Amplitude und keine gleichförmige Bewegung</translation>
    </message>
    <message>
        <source>Write both into its rows.</source>
        <translation>Beides in ihre Zeilen schreiben.</translation>
    </message>
    <message>
        <source>this device follows no table of poses</source>
        <translation>dieses Gerät folgt keiner Tabelle von Lagen</translation>
    </message>
    <message>
        <source>Move one axis: a step, a ramp, a staircase.</source>
        <translation>Eine Achse bewegen: Sprung, Rampe, Treppe.</translation>
    </message>
    <message>
        <source>the table of the reference was not read</source>
        <translation>die Tabelle der Führungsgröße wurde nicht gelesen</translation>
    </message>
    <message>
        <source>Read the file before the move.</source>
        <translation>Die Datei vor der Bewegung lesen.</translation>
    </message>
    <message>
        <source>goes as far as</source>
        <translation>geht bis</translation>
    </message>
    <message>
        <source>largest force over inertia</source>
        <translation>größte Kraft durch Trägheit</translation>
    </message>
    <message>
        <source>Poses count from where the axes stand: move them nearer to the middle first. Nothing moved.</source>
        <translation>Lagen zählen vom Stand der Achsen: sie zuerst näher zur Mitte bewegen. Es hat sich nichts bewegt.</translation>
    </message>
    <message>
        <source>a table moves the axes of its columns</source>
        <translation>eine Tabelle bewegt die Achsen ihrer Spalten</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>It swings out between two rows: use more even times, or a pause. Nothing moved.</source>
        <translation>Sie schwingt zwischen zwei Zeilen aus: gleichmäßigere Zeiten oder eine Pause verwenden. Es hat sich nichts bewegt.</translation>
    </message>
    <message>
        <source>the rate of a table is negative</source>
        <translation>die Geschwindigkeit einer Tabelle ist negativ</translation>
    </message>
    <message>
        <source>Give the largest speed without a sign; the rows say the direction.</source>
        <translation>Die größte Geschwindigkeit ohne Vorzeichen angeben; die Zeilen sagen die Richtung.</translation>
    </message>
    <message>
        <source>{}: row {}: axis {} would come to {} {}, its travel ends at {} {}</source>
        <translation>{}: Zeile {}: Achse {} käme auf {} {}, ihr Weg endet bei {} {}</translation>
    </message>
    <message>
        <source>alpha {}, beta {}, gamma {} deg</source>
        <translation>alpha {}, beta {}, gamma {} Grad</translation>
    </message>
    <message>
        <source>gamma about Z first, then beta about Y, then alpha about X</source>
        <translation>erst gamma um Z, dann beta um Y, dann alpha um X</translation>
    </message>
    <message>
        <source>alpha about X first, then beta about Y, then gamma about Z</source>
        <translation>erst alpha um X, dann beta um Y, dann gamma um Z</translation>
    </message>
    <message>
        <source>alpha about X first, then beta about Y, then gamma about Z, without the roll about the radius</source>
        <translation>erst alpha um X, dann beta um Y, dann gamma um Z, ohne die Drehung um den Radius</translation>
    </message>
    <message>
        <source>orientations that are missing most: {} ({})</source>
        <translation>am meisten fehlende Orientierungen: {} ({})</translation>
    </message>
    <message>
        <source>the placement angles of a sensor turn it in this order: {}</source>
        <translation>die Anordnungswinkel eines Sensors drehen ihn in dieser Reihenfolge: {}</translation>
    </message>
    <message>
        <source>Its values turn_x, turn_y and turn_z are one rotation vector along the stator&apos;s axes.</source>
        <translation>Seine Werte turn_x, turn_y und turn_z sind ein Drehvektor längs der Achsen des Stators.</translation>
    </message>
    <message>
        <source>No row with all nine readings has come yet.</source>
        <translation>Noch ist keine Zeile mit allen neun Messwerten gekommen.</translation>
    </message>
    <message>
        <source>Wait a second, then compare again.</source>
        <translation>Eine Sekunde warten, dann erneut vergleichen.</translation>
    </message>
    <message>
        <source>fault of channel {} of sensor {}</source>
        <translation>Fehler des Kanals {} von Sensor {}</translation>
    </message>
    <message>
        <source>device model: exact, or additive angles as published</source>
        <translation>Gerätemodell: exakt (exact) oder additive Winkel wie veröffentlicht (paper)</translation>
    </message>
    <message>
        <source>how placement angles turn a sensor; nat is unrolled</source>
        <translation>wie Platzierungswinkel einen Sensor drehen; nat ohne Rollen</translation>
    </message>
    <message>
        <source>further harmonics: h1 as finite elements, h2 stress</source>
        <translation>weitere Harmonische: h1 wie Finite Elemente, h2 Belastung</translation>
    </message>
    <message>
        <source>range of the converter: 12 bit, 130mT in steps of 98 uT</source>
        <translation>Messbereich des Wandlers: 12 Bit, 130mT in Schritten von 98 µT</translation>
    </message>
    <message>
        <source>motion of the rotor; published1 to published4 are trajectories</source>
        <translation>Bewegung des Rotors; published1 bis published4 sind Bahnen</translation>
    </message>
    <message>
        <source>Allowed: {}.</source>
        <translation>Erlaubt: {}.</translation>
    </message>
    <message>
        <source>Allowed: {} to {}{}{}. Known keys: {}.</source>
        <translation>Erlaubt: {} bis {}{}{}. Bekannte Schlüssel: {}.</translation>
    </message>
    <message>
        <source>noise of a usual part: noise_uT is 0, 25, 100 or 1000 uT</source>
        <translation>Rauschen eines üblichen Bauteils: noise_uT ist 0, 25, 100 oder 1000 µT</translation>
    </message>
    <message>
        <source>Set-point of the rotation about X; a change ends another motion</source>
        <translation>Sollwert der Drehung um X; beendet eine andere Bewegung</translation>
    </message>
    <message>
        <source>Set-point of the rotation about Y; a change ends another motion</source>
        <translation>Sollwert der Drehung um Y; beendet eine andere Bewegung</translation>
    </message>
    <message>
        <source>Set-point of the rotation about Z; a change ends another motion</source>
        <translation>Sollwert der Drehung um Z; beendet eine andere Bewegung</translation>
    </message>
    <message>
        <source>Fault of this channel, of a simulation only</source>
        <translation>Fehler dieses Kanals, nur in der Simulation</translation>
    </message>
    <message>
        <source>Largest rate towards the set-point</source>
        <translation>Höchste Drehgeschwindigkeit zum Sollwert</translation>
    </message>
    <message>
        <source>Current that the simulation drives through the coil</source>
        <translation>Strom, den die Simulation durch die Spule treibt</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Move the rotor there too. A simulated rotor moves with motion=tumble or motion=walk in its address.</source>
        <translation>Bewegen Sie den Rotor auch dorthin. Ein simulierter Rotor bewegt sich mit motion=tumble oder motion=walk in seiner Adresse.</translation>
    </message>
    <message>
        <source>Use the objective coverage, or the exact device.</source>
        <translation>Das Ziel coverage oder das exakte Modell verwenden.</translation>
    </message>
    <message>
        <source>Sensor 0, which stays on +X, reads up to {} mT: more than the range of {} mT.</source>
        <translation>Sensor 0, der auf +X bleibt, misst bis zu {} mT: mehr als der Messbereich von {} mT.</translation>
    </message>
    <message>
        <source>Use a range of at least {} mT, or sensors {} mm or more from the centre.</source>
        <translation>Einen Messbereich von mindestens {} mT verwenden oder Sensoren {} mm oder mehr vom Mittelpunkt.</translation>
    </message>
    <message>
        <source>Use 1, 1.5, 2.5, 3, 4.5, 5, 7.5, 9, 15, 22.5 or 45 degrees.</source>
        <translation>1, 1,5, 2,5, 3, 4,5, 5, 7,5, 9, 15, 22,5 oder 45 Grad verwenden.</translation>
    </message>
    <message>
        <source>Check the radius of the sensors, the strength of the rotor and the noise.</source>
        <translation>Abstand der Sensoren, Stärke des Rotors und Rauschen prüfen.</translation>
    </message>
    <message>
        <source>dead</source>
        <translation>tot</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>eingefroren</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>am Bereichsende</translation>
    </message>
    <message>
        <source>look for a jump of the angle in the recording, then measure again</source>
        <translation>suchen Sie in der Aufzeichnung nach einem Sprung des Winkels und messen Sie noch einmal</translation>
    </message>
    <message>
        <source>record longer</source>
        <translation>zeichnen Sie länger auf</translation>
    </message>
    <message>
        <source>check the temperature sensors</source>
        <translation>prüfen Sie die Temperatursensoren</translation>
    </message>
    <message>
        <source>the compensation of the stray field leaves {} deg per ampere, more than it should</source>
        <translation>die Kompensation des Streufelds lässt {} Grad je Ampere übrig, mehr als sie sollte</translation>
    </message>
    <message>
        <source>calibrate the stray field, then measure again</source>
        <translation>kalibrieren Sie das Streufeld und messen Sie noch einmal</translation>
    </message>
    <message>
        <source>the platen has no room for a pitch of {} mm along {}: it may move from {} to {} mm, and there only on lines that are {} mm apart</source>
        <translation>die Platte hat keinen Raum für eine Teilung von {} mm entlang {}: sie darf von {} bis {} mm fahren, und dort nur auf Linien im Abstand von {} mm</translation>
    </message>
    <message>
        <source>goes to the middle</source>
        <translation>fährt zur Mitte</translation>
    </message>
    <message>
        <source>{}; axis {} was {} {} from where it began</source>
        <translation>{}; Achse {} war {} {} vom Anfang entfernt</translation>
    </message>
    <message>
        <source>{} of {} orientations do not fit the calibrated model</source>
        <translation>{} von {} Orientierungen passen nicht zum kalibrierten Modell</translation>
    </message>
    <message>
        <source>Check for harmonics of the field beyond those that are fitted, a loose sensor or iron near the rotor.</source>
        <translation>Prüfen Sie, ob das Feld weitere Oberwellen hat, ein Sensor lose oder Eisen nahe dem Rotor ist.</translation>
    </message>
    <message>
        <source>a {} needs {}_deg{} or {}_mm{}</source>
        <translation>{} braucht {}_deg{} oder {}_mm{}</translation>
    </message>
    <message>
        <source>Add {}_deg{}=... or {}_mm{}=... to the reference.</source>
        <translation>Ergänzen Sie {}_deg{}=... oder {}_mm{}=... im Sollwert.</translation>
    </message>
    <message>
        <source>axis {} would come to {} {}, its travel ends at {} {}</source>
        <translation>Achse {} käme bis {} {}, ihr Verfahrweg endet bei {} {}</translation>
    </message>
    <message>
        <source>A reference counts from where the axis stands, now {} {}: move it nearer to the middle first, or less far. Nothing moved.</source>
        <translation>Ein Sollwert zählt von dort, wo die Achse steht, jetzt {} {}: fahren Sie erst näher zur Mitte oder weniger weit. Nichts wurde bewegt.</translation>
    </message>
    <message>
        <source>{}: {} is {} rad, more than a turn</source>
        <translation>{}: {} ist {} rad, mehr als eine Umdrehung</translation>
    </message>
    <message>
        <source>Name columns in degrees alpha_deg, beta_deg, gamma_deg.</source>
        <translation>Nennen Sie Spalten in Grad alpha_deg, beta_deg, gamma_deg.</translation>
    </message>
    <message>
        <source>fault of chip {}</source>
        <translation>Fehler von Chip {}</translation>
    </message>
    <message>
        <source>time after which chips have their faults</source>
        <translation>Zeit, nach der die Chips ihre Fehler haben</translation>
    </message>
    <message>
        <source>model of the coils' forces, section 5</source>
        <translation>Modell der Spulenkräfte, Abschnitt 5</translation>
    </message>
    <message>
        <source>Widen window.x and window.y. The platen was moved; nothing was changed.</source>
        <translation>Erweitern Sie window.x und window.y. Die Platte wurde bewegt; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Write tilts within a turn.</source>
        <translation>Schreiben Sie Neigungen innerhalb einer Umdrehung.</translation>
    </message>
</context>
<context>
    <name>halbench::app::ArmButton</name>
    <message>
        <source>Enable motion; set-points start at zero (Ctrl+Shift+A)</source>
        <translation>Bewegung freigeben; Sollwerte beginnen bei null (Strg+Umschalt+A)</translation>
    </message>
    <message>
        <source>Switch the current off, set-points to zero (Ctrl+Shift+A)</source>
        <translation>Strom aus, Sollwerte auf null (Strg+Umschalt+A)</translation>
    </message>
    <message>
        <source>Keep hands, hair, cables and loose parts clear. Esc stops it.</source>
        <translation>Hände, Haare, Kabel und lose Teile fernhalten. Esc stoppt.</translation>
    </message>
    <message>
        <source>When armed, the actuator can move at any time.</source>
        <translation>Nach der Freigabe kann sich der Aktor jederzeit bewegen.</translation>
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
</context>
<context>
    <name>halbench::app::ArrangementNotice</name>
    <message>
        <source>The old layout stays in the file as %1.</source>
        <translation>Die alte Anordnung bleibt in der Datei unter dem Namen %1.</translation>
    </message>
    <message>
        <source>The panel layout in %1 is from an older version. The default layout is shown.</source>
        <translation>Die Anordnung der Bereiche in %1 stammt aus einer älteren Version. Die Standardanordnung wird gezeigt.</translation>
    </message>
    <message>
        <source>The panel layout in %1 is from a newer version. The default layout is shown.</source>
        <translation>Die Anordnung der Bereiche in %1 stammt aus einer neueren Version. Die Standardanordnung wird gezeigt.</translation>
    </message>
    <message>
        <source>The panel layout in %1 is damaged. The default layout is shown.</source>
        <translation>Die Anordnung der Bereiche in %1 ist beschädigt. Die Standardanordnung wird gezeigt.</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibratePanel</name>
    <message>
        <source>The actuator moves (Ctrl+Return); Esc stops it</source>
        <translation>Der Aktor bewegt sich (Strg+Eingabe); Esc hält ihn an</translation>
    </message>
    <message>
        <source>Field per ampere of every coil in every chip</source>
        <translation>Feld je Ampere jeder Spule in jedem Chip</translation>
    </message>
    <message>
        <source>Amplitude, gains, cross-axis shares, offsets and places of every chip</source>
        <translation>Amplitude, Verstärkungen, Queranteile, Offsets und Orte jedes Chips</translation>
    </message>
    <message>
        <source>Measures the errors of the field sensors and the field of the coils in them.</source>
        <translation>Misst die Fehler der Feldsensoren und das Feld der Spulen in ihnen.</translation>
    </message>
    <message>
        <source>Applied and read back. Lost when the simulated device is disconnected.</source>
        <translation>Übernommen und zurückgelesen. Geht verloren, wenn das simulierte Gerät getrennt wird.</translation>
    </message>
    <message>
        <source>Not on the device yet: press Apply to write the values. Calibrate again after any work on the sensors.</source>
        <translation>Noch nicht im Gerät: „Übernehmen“ schreibt die Werte. Nach Arbeiten an den Sensoren neu kalibrieren.</translation>
    </message>
    <message>
        <source>These values are on the device.</source>
        <translation>Diese Werte sind im Gerät.</translation>
    </message>
    <message>
        <source>Breakaway current over the angle, both directions</source>
        <translation>Losbrechstrom über dem Winkel, beide Richtungen</translation>
    </message>
    <message>
        <source>Distance of the readings from the ellipse over the angle</source>
        <translation>Abstand der Messwerte von der Ellipse über dem Winkel</translation>
    </message>
    <message>
        <source>Hall sensor readings and the fitted ellipse</source>
        <translation>Messwerte der Hall-Sensoren und angepasste Ellipse</translation>
    </message>
    <message>
        <source>Valid only for the device it was measured on. Calibrate again after any work on the sensors.</source>
        <translation>Gilt nur für das Gerät, an dem gemessen wurde. Nach Arbeiten an den Sensoren neu kalibrieren.</translation>
    </message>
    <message>
        <source>Hall sensor readings; centre, axes and tilt of the ellipse are measured</source>
        <translation>Messwerte der Hall-Sensoren; gemessen werden Mitte, Achsen und Neigung der Ellipse</translation>
    </message>
    <message>
        <source>Previous values restored.</source>
        <translation>Vorige Werte wiederhergestellt.</translation>
    </message>
    <message>
        <source>Applied and read back. Lost at power-off.</source>
        <translation>Übernommen und zurückgelesen. Geht beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>Calibration cancelled. Nothing was changed.</source>
        <translation>Kalibrierung abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Back to the settings</source>
        <translation>Zurück zu den Einstellungen</translation>
    </message>
    <message>
        <source>Write all proposed values together, then read them back</source>
        <translation>Alle vorgeschlagenen Werte zusammen schreiben und zurücklesen</translation>
    </message>
    <message>
        <source>For information: changes no parameter</source>
        <translation>Nur zur Information: ändert keinen Parameter</translation>
    </message>
    <message>
        <source>Offsets, gain ratio, orthogonality error and amplitude from the ellipse</source>
        <translation>Offsets, Verstärkungsverhältnis, Orthogonalitätsfehler und Amplitude aus der Ellipse</translation>
    </message>
    <message>
        <source>Measures the errors of the angle sensors, the stray field of the coils and the breakaway current.</source>
        <translation>Misst die Fehler der Winkelsensoren, das Streufeld der Spulen und den Losbrechstrom.</translation>
    </message>
    <message>
        <source>Records a minute (Ctrl+Return) while you move the rotor; Esc stops it</source>
        <translation>Zeichnet eine Minute auf (Strg+Eingabe), während Sie den Rotor bewegen; Esc beendet es</translation>
    </message>
    <message>
        <source>Field per ampere in every channel; the current of the coil has to change</source>
        <translation>Feld je Ampere in jedem Kanal; der Strom der Spule muss sich ändern</translation>
    </message>
    <message>
        <source>Gains, offsets, skews, frames and places of three sensors from a minute of motion</source>
        <translation>Verstärkungen, Offsets, Schiefen, Achsen und Orte von drei Sensoren aus einer Minute Bewegung</translation>
    </message>
    <message>
        <source>Finds gains, offsets, frames and places of the field sensors, and the field of the rotor, from a motion that you make.</source>
        <translation>Findet Verstärkungen, Offsets, Achsen und Orte der Feldsensoren und das Feld des Rotors aus einer Bewegung, die Sie ausführen.</translation>
    </message>
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
        <source>Ha&amp;ll sensors</source>
        <translation>Ha&amp;ll-Sensoren</translation>
    </message>
    <message>
        <source>&amp;Stray field of the coils</source>
        <translation>&amp;Streufeld der Spulen</translation>
    </message>
    <message>
        <source>Without it the recommended gains are unstable</source>
        <translation>Ohne sie sind die empfohlenen Reglerparameter instabil</translation>
    </message>
    <message>
        <source>Static fr&amp;iction</source>
        <translation>Haf&amp;treibung</translation>
    </message>
    <message>
        <source>Start calibration</source>
        <translation>Kalibrierung starten</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Write the values from before the calibration</source>
        <translation>Werte von vor der Kalibrierung schreiben</translation>
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
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Calibrated values</source>
        <translation>Kalibrierte Werte</translation>
    </message>
    <message>
        <source>Hall ellipse</source>
        <translation>Hall-Ellipse</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>Static friction</source>
        <translation>Haftreibung</translation>
    </message>
    <message>
        <source>Pictures of the calibration</source>
        <translation>Bilder der Kalibrierung</translation>
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
        <source>The rotor moves (Ctrl+Return); Esc stops it</source>
        <translation>Der Rotor bewegt sich (Strg+Eingabe); Esc stoppt ihn</translation>
    </message>
    <message>
        <source>Identify next</source>
        <translation>Weiter: identifizieren</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibrateWords</name>
    <message>
        <source>Motion over more than a pitch in each direction for %1 minutes of device time, up to %2 A in a coil. Nothing is changed until you press Apply.</source>
        <translation>Bewegung um mehr als eine Teilung in jede Richtung, %1 Minuten Gerätezeit, bis zu %2 A in einer Spule. Nichts wird geändert, bis Sie Übernehmen drücken.</translation>
    </message>
    <message>
        <source>chip %1: amplitude of the field</source>
        <translation>Chip %1: Amplitude des Felds</translation>
    </message>
    <message>
        <source>chip %1: gain error along x&apos;</source>
        <translation>Chip %1: Verstärkungsfehler entlang x&apos;</translation>
    </message>
    <message>
        <source>chip %1: gain error along y&apos;</source>
        <translation>Chip %1: Verstärkungsfehler entlang y&apos;</translation>
    </message>
    <message>
        <source>chip %1: share of y&apos; in x&apos;</source>
        <translation>Chip %1: Anteil von y&apos; in x&apos;</translation>
    </message>
    <message>
        <source>chip %1: share of x&apos; in y&apos;</source>
        <translation>Chip %1: Anteil von x&apos; in y&apos;</translation>
    </message>
    <message>
        <source>chip %1: offset along x&apos;</source>
        <translation>Chip %1: Offset entlang x&apos;</translation>
    </message>
    <message>
        <source>chip %1: offset along y&apos;</source>
        <translation>Chip %1: Offset entlang y&apos;</translation>
    </message>
    <message>
        <source>chip %1: place along x&apos;</source>
        <translation>Chip %1: Ort entlang x&apos;</translation>
    </message>
    <message>
        <source>chip %1: place along y&apos;</source>
        <translation>Chip %1: Ort entlang y&apos;</translation>
    </message>
    <message>
        <source>field of coil %1 at chip %2 along %3</source>
        <translation>Feld der Spule %1 am Chip %2 entlang %3</translation>
    </message>
    <message>
        <source>periodic error along %1, before</source>
        <translation>periodischer Fehler entlang %1, vorher</translation>
    </message>
    <message>
        <source>periodic error along %1, remaining</source>
        <translation>periodischer Fehler entlang %1, verbleibend</translation>
    </message>
    <message>
        <source>Measured before this connection, device %1.</source>
        <translation>Gemessen vor dieser Verbindung, Gerät %1.</translation>
    </message>
    <message>
        <source>Device stops at %1 %2. Nothing is changed until you press Apply.</source>
        <translation>Das Gerät stoppt bei %1 %2. Bis zum „Übernehmen“ wird nichts geändert.</translation>
    </message>
    <message>
        <source>The breakaway current starts the rotor from rest. Identify gives another figure: K_f/φ, the friction current during rotation, usually less.</source>
        <translation>Der Losbrechstrom setzt den Rotor aus dem Stillstand in Bewegung. „Identifizieren“ liefert eine andere Größe: K_f/φ, den Reibungsstrom während der Drehung, meist kleiner.</translation>
    </message>
    <message>
        <source>Root mean square over one turn of the difference between measured angle and ellipse angle, before the map.</source>
        <translation>Effektivwert der Differenz zwischen gemessenem Winkel und Ellipsenwinkel über eine Umdrehung, vor der Korrekturtabelle.</translation>
    </message>
    <message>
        <source>Residual angle error: %1 with the previous values, %2 with the proposed values.</source>
        <translation>Restwinkelfehler: %1 mit den vorigen Werten, %2 mit den vorgeschlagenen.</translation>
    </message>
    <message>
        <source>breakaway current</source>
        <translation>Losbrechstrom</translation>
    </message>
    <message>
        <source>angle error removed by the map, rms</source>
        <translation>durch die Korrekturtabelle beseitigter Winkelfehler, Effektivwert</translation>
    </message>
    <message>
        <source>angle error, harmonic %1, sine</source>
        <translation>Winkelfehler, Harmonische %1, Sinus</translation>
    </message>
    <message>
        <source>angle error, harmonic %1, cosine</source>
        <translation>Winkelfehler, Harmonische %1, Kosinus</translation>
    </message>
    <message>
        <source>unknown device</source>
        <translation>unbekanntes Gerät</translation>
    </message>
    <message>
        <source>Static friction: the current rises to %1 or until the rotor starts, %2 times in each direction.</source>
        <translation>Haftreibung: Der Strom steigt bis %1 oder bis der Rotor losbricht, %2-mal je Richtung.</translation>
    </message>
    <message>
        <source>Stray field: the rotor is held at three angles with up to %1, without torque.</source>
        <translation>Streufeld: Der Rotor wird in drei Winkeln mit bis zu %1 gehalten, ohne Drehmoment.</translation>
    </message>
    <message>
        <source>Hall: slow rotation in both directions at %1.</source>
        <translation>Hall: langsame Drehung in beide Richtungen mit %1.</translation>
    </message>
    <message>
        <source>orthogonality error of the Hall sensors</source>
        <translation>Orthogonalitätsfehler der Hall-Sensoren</translation>
    </message>
    <message>
        <source>gain ratio B/A</source>
        <translation>Verstärkungsverhältnis B/A</translation>
    </message>
    <message>
        <source>Angle error, rms: %1 with the values from before in this record, %2 expected with the proposed ones.</source>
        <translation>Winkelfehler, Effektivwert: %1 mit den Werten von vorher in dieser Aufzeichnung, %2 mit den vorgeschlagenen erwartet.</translation>
    </message>
    <message>
        <source>Move the rotor: tilt it and spin it.</source>
        <translation>Bewegen Sie den Rotor: Kippen und drehen Sie ihn.</translation>
    </message>
    <message>
        <source>The motion determines every value. More of it makes the intervals smaller.</source>
        <translation>Die Bewegung bestimmt jeden Wert. Mehr davon macht die Intervalle kleiner.</translation>
    </message>
    <message>
        <source>Move the rotor by hand for a minute: tilt it to all sides, up to 45°, and spin it. A simulated rotor moves with motion=tumble in its address. The sphere shows which directions of the shaft still need data.
Nothing is armed. The calibration changes when you apply it; a simulated coil is switched meanwhile and set back.</source>
        <translation>Bewegen Sie den Rotor eine Minute lang von Hand: Kippen Sie ihn nach allen Seiten, bis 45°, und drehen Sie ihn. Ein simulierter Rotor bewegt sich mit motion=tumble in seiner Adresse. Die Kugel zeigt, in welchen Richtungen der Welle noch Daten fehlen.
Nichts wird freigegeben. Die Kalibrierung ändert sich, wenn Sie sie anwenden; eine simulierte Spule wird unterdessen geschaltet und zurückgesetzt.</translation>
    </message>
    <message>
        <source>error left in a reading</source>
        <translation>verbleibender Fehler eines Messwerts</translation>
    </message>
    <message>
        <source>noise of a reading</source>
        <translation>Rauschen eines Messwerts</translation>
    </message>
    <message>
        <source>drift of the field with temperature</source>
        <translation>Drift des Felds mit der Temperatur</translation>
    </message>
    <message>
        <source>strength q of the rotor&apos;s field</source>
        <translation>Stärke q des Rotorfelds</translation>
    </message>
    <message>
        <source>harmonic (%1)</source>
        <translation>Oberwelle (%1)</translation>
    </message>
    <message>
        <source>coil field %1 of sensor %2</source>
        <translation>Spulenfeld %1 von Sensor %2</translation>
    </message>
    <message>
        <source>place along %1 of sensor %2</source>
        <translation>Ort entlang %1 von Sensor %2</translation>
    </message>
    <message>
        <source>frame about %1 of sensor %2</source>
        <translation>Achsen um %1 von Sensor %2</translation>
    </message>
    <message>
        <source>offset %1 of sensor %2</source>
        <translation>Offset %1 von Sensor %2</translation>
    </message>
    <message>
        <source>cross-axis share %1 of sensor %2</source>
        <translation>Queranteil %1 von Sensor %2</translation>
    </message>
    <message>
        <source>gain error %1 of sensor %2</source>
        <translation>Verstärkungsfehler %1 von Sensor %2</translation>
    </message>
    <message>
        <source>offset of Hall sensor A</source>
        <translation>Offset des Hall-Sensors A</translation>
    </message>
    <message>
        <source>offset of Hall sensor B</source>
        <translation>Offset des Hall-Sensors B</translation>
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
        <source>Choose at least one calibration.</source>
        <translation>Wählen Sie mindestens eine Kalibrierung.</translation>
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
        <source>What is the difference?</source>
        <translation>Worin liegt der Unterschied?</translation>
    </message>
    <message>
        <source>Still needed most: %1 (%2)</source>
        <translation>Fehlt noch am meisten: %1 (%2)</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibrationFigures</name>
    <message>
        <source>Residual of the ellipse</source>
        <translation>Residuum der Ellipse</translation>
    </message>
    <message>
        <source>breakaway current</source>
        <translation>Losbrechstrom</translation>
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
</context>
<context>
    <name>halbench::app::ConfigurationPanel</name>
    <message>
        <source>Lost at power-off. To keep: Parameters &gt; Save to device.</source>
        <translation>Gehen beim Ausschalten verloren. Behalten: Parameter &gt; Im Gerät speichern.</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) not restored; see the rows for the cause.</source>
        <translation>
            <numerusform>%n Zeile nicht wiederhergestellt; Ursache siehe Zeile.</numerusform>
            <numerusform>%n Zeilen nicht wiederhergestellt; Ursache siehe Zeilen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Previous device settings saved in %1.</source>
        <translation>Vorige Geräteeinstellungen gespeichert in %1.</translation>
    </message>
    <message>
        <source>Write the ticked rows together and read them back. Lost at power-off unless saved to the device</source>
        <translation>Die angekreuzten Zeilen zusammen schreiben und zurücklesen. Ohne Speichern im Gerät beim Ausschalten verloren</translation>
    </message>
    <message>
        <source>Also tick calibration values; they are valid only for the device they were measured on</source>
        <translation>Auch Kalibrierwerte ankreuzen; sie gelten nur für das Gerät, an dem sie gemessen wurden</translation>
    </message>
    <message>
        <source>Hide rows that are equal or missing in the file</source>
        <translation>Zeilen ausblenden, die gleich sind oder in der Datei fehlen</translation>
    </message>
    <message>
        <source>Only &amp;differences</source>
        <translation>Nur A&amp;bweichungen</translation>
    </message>
    <message>
        <source>A file is compared with the device row by row. Tick rows to restore them. The present device settings are saved first.</source>
        <translation>Eine Datei wird zeilenweise mit dem Gerät verglichen. Angekreuzte Zeilen werden wiederhergestellt. Die jetzigen Geräteeinstellungen werden vorher gespeichert.</translation>
    </message>
    <message>
        <source>Compare a file with the device; nothing is written yet</source>
        <translation>Datei mit dem Gerät vergleichen; noch wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Save all device settings to a file</source>
        <translation>Alle Geräteeinstellungen in einer Datei speichern</translation>
    </message>
    <message>
        <source>No configuration file is open</source>
        <translation>Keine Konfigurationsdatei ist offen</translation>
    </message>
    <message>
        <source>With &amp;calibration</source>
        <translation>Mit &amp;Kalibrierung</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
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
    <message numerus="yes">
        <source>%n row(s) restored and read back.</source>
        <translation>
            <numerusform>%n Zeile wiederhergestellt und zurückgelesen.</numerusform>
            <numerusform>%n Zeilen wiederhergestellt und zurückgelesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>configuration</source>
        <translation>Konfiguration</translation>
    </message>
    <message>
        <source>Save settings…</source>
        <translation>Einstellungen speichern …</translation>
    </message>
    <message>
        <source>Compare with…</source>
        <translation>Vergleichen mit …</translation>
    </message>
    <message>
        <source>Compare with a file…</source>
        <translation>Mit einer Datei vergleichen …</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConfigurationTable</name>
    <message>
        <source>differs; calibration value, valid for one device only</source>
        <translation>verschieden; Kalibrierwert, gilt nur für ein Gerät</translation>
    </message>
    <message>
        <source>Ticked rows are restored (Space). Values in SI units, as in the file</source>
        <translation>Angekreuzte Zeilen werden wiederhergestellt (Leertaste). Werte in SI-Einheiten, wie in der Datei</translation>
    </message>
    <message>
        <source>Rows of the configuration</source>
        <translation>Zeilen der Konfiguration</translation>
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
</context>
<context>
    <name>halbench::app::ConnectButton</name>
    <message>
        <source>Stop searching for the device (Ctrl+Shift+C)</source>
        <translation>Suche nach dem Gerät beenden (Strg+Umschalt+C)</translation>
    </message>
    <message>
        <source>Stop, disarm and disconnect (Ctrl+Shift+C)</source>
        <translation>Stoppen, sperren und trennen (Strg+Umschalt+C)</translation>
    </message>
    <message>
        <source>Connect the selected device (Ctrl+Shift+C; list: Alt+Down)</source>
        <translation>Gewähltes Gerät verbinden (Strg+Umschalt+C; Liste: Alt+Ab)</translation>
    </message>
    <message>
        <source>Close the recording (Ctrl+Shift+C)</source>
        <translation>Aufzeichnung schließen (Strg+Umschalt+C)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Close the recording, back to %1 (Ctrl+Shift+C)</source>
        <translation>Aufzeichnung schließen, zurück zu %1 (Strg+Umschalt+C)</translation>
    </message>
</context>
<context>
    <name>halbench::app::DepartureWords</name>
    <message>
        <source>The device was disarmed first and its settings were restored. Start again after reconnecting.</source>
        <translation>Das Gerät wurde zuerst gesperrt, seine Einstellungen wurden wiederhergestellt. Nach dem Wiederverbinden neu starten.</translation>
    </message>
    <message>
        <source>Stopped: the device was disconnected.</source>
        <translation>Beendet: Das Gerät wurde getrennt.</translation>
    </message>
    <message>
        <source>The device&apos;s watchdog disarms it. Start again after reconnecting.</source>
        <translation>Der Watchdog des Geräts sperrt es. Nach dem Wiederverbinden neu starten.</translation>
    </message>
    <message>
        <source>Stopped: connection to the device lost: %1.</source>
        <translation>Beendet: Verbindung zum Gerät verloren: %1.</translation>
    </message>
</context>
<context>
    <name>halbench::app::DerivedPanel</name>
    <message>
        <source>Remove the selected signal (Delete)</source>
        <translation>Gewähltes Signal entfernen (Entf)</translation>
    </message>
    <message>
        <source>Add the signal; computed from now on (Enter)</source>
        <translation>Signal hinzufügen; wird ab jetzt berechnet (Eingabe)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Unit of the result, e.g. rad, rad/s, T, A, degC; empty: derived from the expression</source>
        <translation>Einheit des Ergebnisses, z. B. rad, rad/s, T, A, degC; leer: aus dem Ausdruck abgeleitet</translation>
    </message>
    <message>
        <source>Name in the signal tree: letters, digits, dots, underscores</source>
        <translation>Name im Signalbaum: Buchstaben, Ziffern, Punkte, Unterstriche</translation>
    </message>
    <message>
        <source>Enter copies a row into the fields above, Delete removes it</source>
        <translation>Eingabe kopiert eine Zeile in die Felder oben, Entf entfernt sie</translation>
    </message>
    <message>
        <source>Error in the expression</source>
        <translation>Fehler im Ausdruck</translation>
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
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>waits for a device</source>
        <translation>wartet auf ein Gerät</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>wird berechnet</translation>
    </message>
    <message>
        <source>sine of an angle in rad</source>
        <translation>Sinus eines Winkels in rad</translation>
    </message>
    <message>
        <source>cosine of an angle in rad</source>
        <translation>Kosinus eines Winkels in rad</translation>
    </message>
    <message>
        <source>angle of the point (x, y): atan2(y, x)</source>
        <translation>Winkel des Punktes (x, y): atan2(y, x)</translation>
    </message>
    <message>
        <source>square root</source>
        <translation>Quadratwurzel</translation>
    </message>
    <message>
        <source>absolute value</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>exponential function</source>
        <translation>Exponentialfunktion</translation>
    </message>
    <message>
        <source>natural logarithm</source>
        <translation>natürlicher Logarithmus</translation>
    </message>
    <message>
        <source>smaller of two values</source>
        <translation>kleinerer von zwei Werten</translation>
    </message>
    <message>
        <source>larger of two values</source>
        <translation>größerer von zwei Werten</translation>
    </message>
    <message>
        <source>ratio of circumference to diameter</source>
        <translation>Verhältnis von Umfang zu Durchmesser</translation>
    </message>
    <message>
        <source>Signals in SI units, e.g. current.a^2 (Enter adds it)</source>
        <translation>Signale in SI-Einheiten, z. B. current.a^2 (Eingabe fügt hinzu)</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Insert a signal or a function into the expression</source>
        <translation>Signal oder Funktion in den Ausdruck einfügen</translation>
    </message>
    <message>
        <source>No derived signals yet. Example: name power, expression current.a^2 + current.b^2.
Type a part of a signal&apos;s name to choose it, or drag it here from the signals.</source>
        <translation>Noch keine abgeleiteten Signale. Beispiel: Name power, Ausdruck current.a^2 + current.b^2.
Einen Teil des Signalnamens eingeben und wählen, oder das Signal aus der Liste hierher ziehen.</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Funktion</translation>
    </message>
</context>
<context>
    <name>halbench::app::DesignNames</name>
    <message>
        <source>edited manually</source>
        <translation>von Hand bearbeitet</translation>
    </message>
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
</context>
<context>
    <name>halbench::app::DesignTable</name>
    <message>
        <source>Redo the last undone change (Ctrl+Shift+Z)</source>
        <translation>Letzte rückgängig gemachte Änderung wiederholen (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Undo the last change of the list (Ctrl+Z)</source>
        <translation>Letzte Änderung der Liste rückgängig machen (Strg+Z)</translation>
    </message>
    <message>
        <source>Remove the selected design from the project</source>
        <translation>Gewählten Entwurf aus dem Projekt entfernen</translation>
    </message>
    <message>
        <source>Use the gains of the selected design as proposed gains</source>
        <translation>Reglerparameter des gewählten Entwurfs als Vorschlag verwenden</translation>
    </message>
    <message>
        <source>Use this design</source>
        <translation>Entwurf verwenden</translation>
    </message>
    <message>
        <source>Save the proposed gains in the project under a name</source>
        <translation>Vorgeschlagene Reglerparameter unter einem Namen im Projekt speichern</translation>
    </message>
    <message>
        <source>Save design</source>
        <translation>Entwurf speichern</translation>
    </message>
    <message>
        <source>A tick shows the design in the plots (Space), F2 renames it, Del removes it</source>
        <translation>Ein Häkchen zeigt den Entwurf in den Diagrammen (Leertaste), F2 benennt ihn um, Entf entfernt ihn</translation>
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
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>%1, with filters</source>
        <translation>%1, mit Filtern</translation>
    </message>
</context>
<context>
    <name>halbench::app::DevicePanel</name>
    <message>
        <source>A2L file from the manufacturer, for boards without a built-in description</source>
        <translation>A2L-Datei des Herstellers, für Steuergeräte ohne eigene Beschreibung</translation>
    </message>
    <message>
        <source>not specified</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>Stop searching for the device (Alt+C)</source>
        <translation>Suche nach dem Gerät beenden (Alt+C)</translation>
    </message>
    <message>
        <source>Stop, disarm and disconnect (Alt+C)</source>
        <translation>Stoppen, sperren und trennen (Alt+N)</translation>
    </message>
    <message>
        <source>Choose one from the list or enter its address.</source>
        <translation>Gerät aus der Liste wählen oder Adresse eingeben.</translation>
    </message>
    <message>
        <source>No device selected.</source>
        <translation>Kein Gerät gewählt.</translation>
    </message>
    <message>
        <source>Model, identity and firmware reported by the device</source>
        <translation>Modell, Kennung und Firmware laut Gerät</translation>
    </message>
    <message>
        <source>Device identification</source>
        <translation>Geräteidentifikation</translation>
    </message>
    <message>
        <source>Example: sim:htm?seed=7 or tcp:HOST:PORT</source>
        <translation>Beispiel: sim:htm?seed=7 oder tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>Enter or double-click connects</source>
        <translation>Eingabetaste oder Doppelklick verbindet</translation>
    </message>
    <message>
        <source>Available devices</source>
        <translation>Verfügbare Geräte</translation>
    </message>
    <message>
        <source>Device address</source>
        <translation>Adresse des Geräts</translation>
    </message>
    <message>
        <source>sim:htm or tcp:HOST:PORT</source>
        <translation>sim:htm oder tcp:HOST:PORT</translation>
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
        <source>%1
Firmware %2</source>
        <translation>%1
Firmware %2</translation>
    </message>
    <message>
        <source>%1, last used</source>
        <translation>%1, zuletzt verwendet</translation>
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
        <source>Description file…</source>
        <translation>Beschreibungsdatei …</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Close the recording, back to %1 (Alt+B)</source>
        <translation>Aufzeichnung schließen, zurück zu %1 (Alt+Z)</translation>
    </message>
    <message>
        <source>Stopping and disarming…</source>
        <translation>Stoppt und sperrt …</translation>
    </message>
    <message>
        <source>Connection lost. Reconnecting to %1…</source>
        <translation>Verbindung verloren. Verbindet erneut mit %1 …</translation>
    </message>
    <message>
        <source>Simulation options…</source>
        <translation>Optionen der Simulation…</translation>
    </message>
    <message>
        <source>Values of the simulated actuator: motion, noise, faults…</source>
        <translation>Werte des simulierten Aktors: Bewegung, Rauschen, Fehler…</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>No device found on USB or a serial port.</source>
        <translation>Kein Gerät an USB oder einer seriellen Schnittstelle gefunden.</translation>
    </message>
    <message>
        <source>%1, simulated (%2)</source>
        <translation>%1, simuliert (%2)</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Copy address</source>
        <translation>Adresse kopieren</translation>
    </message>
</context>
<context>
    <name>halbench::app::DeviceSession</name>
    <message>
        <source>armed: will be disarmed before disconnecting</source>
        <translation>freigegeben: wird vor dem Trennen gesperrt</translation>
    </message>
    <message numerus="yes">
        <source>%Ln sample(s) not shown: rate too high for the window</source>
        <translation>
            <numerusform>%Ln Messwert nicht gezeigt: Rate zu hoch für das Fenster</numerusform>
            <numerusform>%Ln Messwerte nicht gezeigt: Rate zu hoch für das Fenster</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reconnected after %2 s, disarmed</source>
        <translation>%1 nach %2 s wieder verbunden, gesperrt</translation>
    </message>
    <message>
        <source>%1 more messages not shown (too many at once)</source>
        <translation>%1 weitere Meldungen nicht gezeigt (zu viele auf einmal)</translation>
    </message>
    <message>
        <source>Window not responding while armed: actuator stopped</source>
        <translation>Fenster reagierte nicht bei freigegebenem Aktor: Aktor gestoppt</translation>
    </message>
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
        <source>back to %1</source>
        <translation>zurück zu %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::DisplayQuantity</name>
    <message>
        <source>Inconsistent parameter sets</source>
        <translation>Inkonsistente Parametersätze</translation>
    </message>
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
    <message>
        <source>Lift force</source>
        <translation>Hubkraft</translation>
    </message>
    <message>
        <source>Chi-square</source>
        <translation>Chi-Quadrat</translation>
    </message>
    <message>
        <source>Squared innovation</source>
        <translation>Innovationsquadrat</translation>
    </message>
    <message>
        <source>Current scale</source>
        <translation>Stromskalierung</translation>
    </message>
    <message>
        <source>Cell x</source>
        <translation>Zelle x</translation>
    </message>
    <message>
        <source>Cell y</source>
        <translation>Zelle y</translation>
    </message>
    <message>
        <source>Sensors left out</source>
        <translation>Ausgelassene Sensoren</translation>
    </message>
    <message>
        <source>Channels left out</source>
        <translation>Ausgelassene Kanäle</translation>
    </message>
    <message>
        <source>Homed</source>
        <translation>Referenziert</translation>
    </message>
    <message>
        <source>Field strength</source>
        <translation>Feldstärke</translation>
    </message>
    <message>
        <source>Expected field strength</source>
        <translation>Erwartete Feldstärke</translation>
    </message>
    <message>
        <source>Shaft cone (95 %)</source>
        <translation>Wellenkegel (95 %)</translation>
    </message>
    <message>
        <source>Orientation state</source>
        <translation>Zustand der Orientierung</translation>
    </message>
    <message>
        <source>Integrity code</source>
        <translation>Integritätscode</translation>
    </message>
    <message>
        <source>Coil current</source>
        <translation>Spulenstrom</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>True field strength</source>
        <translation>Wahre Feldstärke</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>Geschwindigkeit %1</translation>
    </message>
    <message>
        <source>Reference %1</source>
        <translation>Referenz %1</translation>
    </message>
    <message>
        <source>Command %1</source>
        <translation>Stellbefehl %1</translation>
    </message>
    <message>
        <source>Effort %1</source>
        <translation>Stellgröße %1</translation>
    </message>
    <message>
        <source>True position %1</source>
        <translation>Wahre Position %1</translation>
    </message>
    <message>
        <source>True speed %1</source>
        <translation>Wahre Geschwindigkeit %1</translation>
    </message>
    <message>
        <source>True effort %1</source>
        <translation>Wahre Stellgröße %1</translation>
    </message>
    <message>
        <source>Orientation %1</source>
        <translation>Orientierung %1</translation>
    </message>
    <message>
        <source>Shaft %1</source>
        <translation>Welle %1</translation>
    </message>
    <message>
        <source>True rate %1</source>
        <translation>Wahre Drehrate %1</translation>
    </message>
    <message>
        <source>True orientation %1</source>
        <translation>Wahre Orientierung %1</translation>
    </message>
    <message>
        <source>Hall %1</source>
        <translation>Hall %1</translation>
    </message>
    <message>
        <source>Current %1</source>
        <translation>Strom %1</translation>
    </message>
    <message>
        <source>Coil %1</source>
        <translation>Spule %1</translation>
    </message>
    <message>
        <source>Field %1</source>
        <translation>Feld %1</translation>
    </message>
    <message>
        <source>Residual %1</source>
        <translation>Residuum %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::DockLayout</name>
    <message>
        <source>Show or hide this panel (%1)</source>
        <translation>Diesen Bereich zeigen oder verbergen (%1)</translation>
    </message>
</context>
<context>
    <name>halbench::app::DockMenu</name>
    <message>
        <source>P&amp;anel layout “%1”</source>
        <translation>Bereich „%1“ &amp;anordnen</translation>
    </message>
    <message>
        <source>P&amp;anel layout</source>
        <translation>Bereich &amp;anordnen</translation>
    </message>
    <message>
        <source>Change the panel&apos;s size; neighbouring panels adjust</source>
        <translation>Größe des Bereichs ändern; Nachbarbereiche passen sich an</translation>
    </message>
    <message>
        <source>Move the panel to the next place on that side or edge</source>
        <translation>Bereich an den nächsten Platz auf dieser Seite verschieben</translation>
    </message>
    <message>
        <source>Move the panel to its own window with STOP, or dock it again</source>
        <translation>Bereich in ein eigenes Fenster mit STOPP lösen oder wieder andocken</translation>
    </message>
    <message>
        <source>Brings the tab beside it to the front, with the focus</source>
        <translation>Holt den Reiter daneben nach vorn, mit dem Fokus</translation>
    </message>
    <message>
        <source>&amp;Previous tab</source>
        <translation>&amp;Voriger Reiter</translation>
    </message>
    <message>
        <source>Ne&amp;xt tab</source>
        <translation>Nä&amp;chster Reiter</translation>
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
        <source>Plotted data (*.csv)</source>
        <translation>Dargestellte Daten (*.csv)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Picture (*.svg *.pdf *.png)</source>
        <translation>Bild (*.svg *.pdf *.png)</translation>
    </message>
</context>
<context>
    <name>halbench::app::ReferenceRun</name>
    <message>
        <source>Disarm and arm, then start. Firmware 0.2.0 and later starts at the present position.</source>
        <translation>Sperren und freigeben, dann starten. Firmware ab 0.2.0 beginnt an der jetzigen Position.</translation>
    </message>
    <message>
        <source>Not started: with this firmware (%1) the motion would begin at the arming position and the rotor would jump.</source>
        <translation>Nicht gestartet: Mit dieser Firmware (%1) beginnt die Bewegung an der Freigabeposition; der Rotor würde springen.</translation>
    </message>
</context>
<context>
    <name>halbench::app::SetpointMotion</name>
    <message>
        <source>Not sent: a step above %1 is too large, and this firmware has no ramp.</source>
        <translation>Nicht gesendet: Ein Sprung über %1 ist zu groß, und diese Firmware hat keine Rampe.</translation>
    </message>
    <message>
        <source>Not sent: a reference is running, and a step above %1 is too large.</source>
        <translation>Nicht gesendet: Eine Führungsgröße läuft, und ein Sprung über %1 ist zu groß.</translation>
    </message>
    <message>
        <source>Use smaller steps or jog. Firmware 0.2.0 and later moves in a ramp.</source>
        <translation>Kleinere Schritte oder Tippbetrieb verwenden. Firmware ab 0.2.0 fährt als Rampe.</translation>
    </message>
    <message>
        <source>End the reference first. The device then moves there in a ramp.</source>
        <translation>Zuerst die Führungsgröße beenden. Das Gerät fährt dann als Rampe dorthin.</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveLimits</name>
    <message>
        <source>Enter writes it. Lost at power-off unless saved to the device</source>
        <translation>Eingabetaste schreibt ihn. Ohne Speichern im Gerät beim Ausschalten verloren</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid limit. Nothing was written.</source>
        <translation>„%1“ ist kein gültiger Grenzwert. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Off: not monitored (Space)</source>
        <translation>Aus: nicht überwacht (Leertaste)</translation>
    </message>
    <message>
        <source>Device stops above this speed</source>
        <translation>Das Gerät stoppt über dieser Drehzahl</translation>
    </message>
    <message>
        <source>Device stops at this distance from the arming position</source>
        <translation>Das Gerät stoppt bei diesem Abstand von der Freigabeposition</translation>
    </message>
    <message>
        <source>Device stops when a coil is hotter</source>
        <translation>Das Gerät stoppt, wenn eine Spule heißer ist</translation>
    </message>
    <message>
        <source>Hottest coil</source>
        <translation>Heißeste Spule</translation>
    </message>
    <message>
        <source>Maximum current. A larger command in current mode stops the device</source>
        <translation>Maximaler Strom. Ein größerer Sollwert im Strommodus stoppt das Gerät</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Excursion</source>
        <translation>Auslenkung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>Grenzwert: %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::DrivePanel</name>
    <message>
        <source>Lost at power-off. To keep: Parameters &gt; Save to device.</source>
        <translation>Gehen beim Ausschalten verloren. Behalten: Parameter &gt; Im Gerät speichern.</translation>
    </message>
    <message>
        <source>Start the reference from the present set-point; repeated starts
add up (Ctrl+Shift+R)</source>
        <translation>Führungsgröße ab dem jetzigen Sollwert starten; wiederholte Starts
addieren sich (Strg+Umschalt+R)</translation>
    </message>
    <message>
        <source>Send the set-point (Enter in the field). Long moves
are ramps at jog speed.</source>
        <translation>Sollwert senden (Eingabetaste im Feld). Lange Wege
sind Rampen mit Tippgeschwindigkeit.</translation>
    </message>
    <message>
        <source>Axis for set-point, jog and reference; other axes hold (Alt+X)</source>
        <translation>Achse für Sollwert, Tippen und Führungsgröße; andere Achsen halten (Alt+X)</translation>
    </message>
    <message>
        <source>Without the offset from a finished reference (Enter sends it)</source>
        <translation>Ohne den Versatz aus einer beendeten Führungsgröße (Eingabetaste sendet)</translation>
    </message>
    <message>
        <source>Waiting for the first angle sample.</source>
        <translation>Wartet auf den ersten Winkelmesswert.</translation>
    </message>
    <message>
        <source>Send set-point zero: move back by %1 at jog speed</source>
        <translation>Sollwert null senden: mit Tippgeschwindigkeit um %1 zurück</translation>
    </message>
    <message>
        <source>Send set-point zero: step back by %1</source>
        <translation>Sollwert null senden: Sprung um %1 zurück</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Armed: %1</source>
        <translation>Freigegeben: %1</translation>
    </message>
    <message>
        <source>Allowed now: %1 to %2. Widen the window, or disarm and arm to set a new zero.</source>
        <translation>Jetzt erlaubt: %1 bis %2. Fenster erweitern, oder sperren und freigeben für einen neuen Nullpunkt.</translation>
    </message>
    <message>
        <source>%1 is outside the excursion window. Nothing was sent.</source>
        <translation>%1 liegt außerhalb des Auslenkungsfensters. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Stopped while disarmed</source>
        <translation>Gestoppt bei gesperrtem Gerät</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid set-point. Nothing was sent.</source>
        <translation>„%1“ ist kein gültiger Sollwert. Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Above the limit: the device may stop.</source>
        <translation>Über dem Grenzwert: Das Gerät kann stoppen.</translation>
    </message>
    <message>
        <source>Range: up to %1.</source>
        <translation>Bereich: bis %1.</translation>
    </message>
    <message>
        <source>Device limits</source>
        <translation>Gerätegrenzwerte</translation>
    </message>
    <message>
        <source>End the reference: position is held, current goes to 0 (Ctrl+Shift+E)</source>
        <translation>Führungsgröße beenden: Position wird gehalten, Strom geht auf 0 (Strg+Umschalt+E)</translation>
    </message>
    <message>
        <source>Send set-point zero</source>
        <translation>Sollwert null senden</translation>
    </message>
    <message>
        <source>State reported by the device</source>
        <translation>Vom Gerät gemeldeter Zustand</translation>
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
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
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
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>Achse (&amp;X)</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source> (%1)</source>
        <translation> (%1)</translation>
    </message>
    <message>
        <source>Position relative to the arming position</source>
        <translation>Position relativ zur Freigabeposition</translation>
    </message>
    <message>
        <source>Position relative to the mode&apos;s start</source>
        <translation>Position relativ zum Beginn der Betriebsart</translation>
    </message>
    <message>
        <source>Set-point %1</source>
        <translation>Sollwert %1</translation>
    </message>
    <message>
        <source>Arm to move. Set-points start at 0.</source>
        <translation>Zum Bewegen freigeben. Sollwerte beginnen bei 0.</translation>
    </message>
    <message>
        <source>Set-point %1 + jog or reference %2</source>
        <translation>Sollwert %1 + Tippen oder Führungsgröße %2</translation>
    </message>
    <message>
        <source>Travel: up to %1 from here.</source>
        <translation>Weg: bis %1 von hier.</translation>
    </message>
    <message>
        <source>Travel: up to %1 from here, up to %2 from the arming position.</source>
        <translation>Weg: bis %1 von hier, bis %2 von der Freigabeposition.</translation>
    </message>
    <message>
        <source>A motion is running. End it to start another.</source>
        <translation>Eine Bewegung läuft. Beenden Sie sie, um eine andere zu starten.</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Aufheben</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveWords</name>
    <message>
        <source>%1, %2 mode</source>
        <translation>%1, Modus %2</translation>
    </message>
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
        <source>trapezoid</source>
        <translation>Trapez</translation>
    </message>
    <message>
        <source>s-curve</source>
        <translation>S-Kurve</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>raster</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>table of poses</source>
        <translation>Tabelle von Lagen</translation>
    </message>
</context>
<context>
    <name>halbench::app::FaultWords</name>
    <message>
        <source>Check the board&apos;s cables and supply, then release the stop.</source>
        <translation>Kabel und Versorgung des Steuergeräts prüfen, dann den Stopp aufheben.</translation>
    </message>
    <message>
        <source>Output converter of a coil not responding</source>
        <translation>Ausgangswandler einer Spule antwortet nicht</translation>
    </message>
    <message>
        <source>Write proven gains.</source>
        <translation>Bewährte Reglerparameter schreiben.</translation>
    </message>
    <message>
        <source>Controller output is not a number</source>
        <translation>Reglerausgang ist keine Zahl</translation>
    </message>
    <message>
        <source>Check the sensors and their connector, then calibrate the Hall sensors.</source>
        <translation>Sensoren und Stecker prüfen, dann die Hall-Sensoren kalibrieren.</translation>
    </message>
    <message>
        <source>Hall sensor out of range</source>
        <translation>Hall-Sensor außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Turn more slowly. Check for magnets or iron near the Hall sensors.</source>
        <translation>Langsamer drehen. Auf Magnete oder Eisen nahe den Hall-Sensoren prüfen.</translation>
    </message>
    <message>
        <source>Use a smaller motion, or widen the excursion window.</source>
        <translation>Kleinere Bewegung verwenden, oder das Auslenkungsfenster erweitern.</translation>
    </message>
    <message>
        <source>Position outside its window</source>
        <translation>Position außerhalb des Fensters</translation>
    </message>
    <message>
        <source>Use less current or a slower reference, or widen the speed window.</source>
        <translation>Weniger Strom oder eine langsamere Führungsgröße verwenden, oder das Drehzahlfenster erweitern.</translation>
    </message>
    <message>
        <source>Speed above its limit</source>
        <translation>Drehzahl über dem Grenzwert</translation>
    </message>
    <message>
        <source>Current command above the limit</source>
        <translation>Stromsollwert über dem Grenzwert</translation>
    </message>
    <message>
        <source>Let the coils cool. Use less current or add pauses.</source>
        <translation>Spulen abkühlen lassen. Weniger Strom oder Pausen verwenden.</translation>
    </message>
    <message>
        <source>Coil temperature above its limit</source>
        <translation>Spulentemperatur über dem Grenzwert</translation>
    </message>
    <message>
        <source>Release the stop, then arm, to move again.</source>
        <translation>Zum Weiterfahren Stopp aufheben, dann freigeben.</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Use a smaller set-point or amplitude.</source>
        <translation>Verwenden Sie einen kleineren Sollwert oder eine kleinere Amplitude.</translation>
    </message>
    <message>
        <source>The measured angle jumped</source>
        <translation>Der gemessene Winkel ist gesprungen</translation>
    </message>
    <message>
        <source>by command</source>
        <translation>durch Befehl</translation>
    </message>
    <message>
        <source>by the watchdog</source>
        <translation>durch Watchdog</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Gestoppt: %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::FieldPanel</name>
    <message>
        <source>This device has no signals that a picture could be made of.</source>
        <translation>Dieses Gerät hat keine Signale, aus denen ein Bild entstehen könnte.</translation>
    </message>
    <message>
        <source>Shows the rotor or platen of a connected actuator, with its field.</source>
        <translation>Zeigt den Rotor oder die Platte eines verbundenen Aktors mit dem Feld.</translation>
    </message>
    <message>
        <source>Save as SVG, PDF or PNG (Alt+P)</source>
        <translation>Als SVG, PDF oder PNG speichern (Alt+P)</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>Bild s&amp;peichern…</translation>
    </message>
</context>
<context>
    <name>halbench::app::FilterEditor</name>
    <message>
        <source>Time constant; 0: difference of two samples</source>
        <translation>Zeitkonstante; 0: Differenz zweier Abtastwerte</translation>
    </message>
    <message>
        <source>Weight on K_D: 0 ignores a set-point step, 1 passes all of it</source>
        <translation>Gewicht auf K_D: 0 ignoriert einen Sollwertsprung, 1 lässt ihn ganz durch</translation>
    </message>
    <message>
        <source>Set-point weights, derivative filter and series filters</source>
        <translation>Sollwertgewichtung, Filter des D-Anteils und Filter in Reihe</translation>
    </message>
    <message>
        <source>Lead: adds phase at a frequency. Lag: raises the DC gain. Notch: lowers the gain at a frequency. Low-pass: lowers the gain above a frequency. Section: second order by coefficients</source>
        <translation>Lead: hebt die Phase bei einer Frequenz. Lag: erhöht die Gleichverstärkung. Notch: senkt die Verstärkung bei einer Frequenz. Tiefpass: senkt die Verstärkung über einer Frequenz. Glied 2. Ordnung: durch Koeffizienten</translation>
    </message>
    <message>
        <source>Coefficient of d in the denominator; 0: no dynamics</source>
        <translation>Koeffizient von d im Nenner; 0: keine Dynamik</translation>
    </message>
    <message>
        <source>Frequency of −3 dB</source>
        <translation>Frequenz von −3 dB</translation>
    </message>
    <message>
        <source>Damping of the poles: larger is wider</source>
        <translation>Dämpfung der Pole: größer ist breiter</translation>
    </message>
    <message>
        <source>Gain factor at this frequency, 0 to 1</source>
        <translation>Verstärkungsfaktor bei dieser Frequenz, 0 bis 1</translation>
    </message>
    <message>
        <source>Frequency of minimum gain</source>
        <translation>Frequenz der kleinsten Verstärkung</translation>
    </message>
    <message>
        <source>Factor on the DC gain, above 1</source>
        <translation>Faktor auf die Gleichverstärkung, über 1</translation>
    </message>
    <message>
        <source>Gain is unchanged far above this frequency</source>
        <translation>Weit über dieser Frequenz bleibt die Verstärkung gleich</translation>
    </message>
    <message>
        <source>Phase added at this frequency</source>
        <translation>Phasenanhebung bei dieser Frequenz</translation>
    </message>
    <message>
        <source>Frequency of the added phase; the gain there is unchanged</source>
        <translation>Frequenz der Phasenanhebung; die Verstärkung bleibt dort gleich</translation>
    </message>
    <message>
        <source>Derivative filter time</source>
        <translation>Filterzeit des D-Anteils</translation>
    </message>
    <message>
        <source>Set-point weight c (D)</source>
        <translation>Sollwertgewichtung c (D)</translation>
    </message>
    <message>
        <source>Weight on K_P: below 1 gives a softer set-point step</source>
        <translation>Gewicht auf K_P: unter 1 wird der Sollwertsprung weicher</translation>
    </message>
    <message>
        <source>Set-point weight b (P)</source>
        <translation>Sollwertgewichtung b (P)</translation>
    </message>
    <message>
        <source>In series with the others, four at most; low-pass first</source>
        <translation>In Reihe mit den anderen, höchstens vier; zuerst Tiefpass</translation>
    </message>
    <message>
        <source>DC gain</source>
        <translation>Gleichverstärkung</translation>
    </message>
    <message>
        <source>Enter a number within the range</source>
        <translation>Eine Zahl im Bereich eingeben</translation>
    </message>
    <message>
        <source>missing number</source>
        <translation>fehlende Zahl</translation>
    </message>
    <message>
        <source>Type of filter %1</source>
        <translation>Typ von Filter %1</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>%1 bearbeiten</translation>
    </message>
    <message>
        <source>Add a filter</source>
        <translation>Filter hinzufügen</translation>
    </message>
    <message>
        <source>Remove a filter</source>
        <translation>Filter entfernen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
        <source>Coefficient of 1 in the denominator</source>
        <translation>Koeffizient von 1 im Nenner</translation>
    </message>
    <message>
        <source>For analysis and C export. A connected device may run them as well.</source>
        <translation>Für Analyse und C-Export. Ein verbundenes Gerät kann sie eventuell auch ausführen.</translation>
    </message>
    <message>
        <source>This device runs them, with up to %1 filters.</source>
        <translation>Dieses Gerät führt sie aus, mit bis zu %1 Filtern.</translation>
    </message>
    <message>
        <source>This device runs a part of them; the others are for analysis and C export only.</source>
        <translation>Dieses Gerät führt einen Teil davon aus; die übrigen dienen nur der Analyse und dem C-Export.</translation>
    </message>
    <message>
        <source>This device does not run them: for analysis and C export only.</source>
        <translation>Dieses Gerät führt sie nicht aus: nur für Analyse und C-Export.</translation>
    </message>
</context>
<context>
    <name>halbench::app::ForeignMotorNotice</name>
    <message>
        <source>Motor that the gains are designed for</source>
        <translation>Motor, für den die Reglerparameter ausgelegt werden</translation>
    </message>
    <message>
        <source>The gains were designed for a motor that may differ from this one</source>
        <translation>Die Reglerparameter wurden für einen womöglich anderen Motor entworfen</translation>
    </message>
    <message>
        <source>Apply the gains of another motor</source>
        <translation>Reglerparameter eines anderen Motors übernehmen</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyFigures</name>
    <message>
        <source>Excitation as recorded</source>
        <translation>Anregung, wie aufgezeichnet</translation>
    </message>
    <message>
        <source>fitted rotor</source>
        <translation>angepasster Rotor</translation>
    </message>
    <message>
        <source>95 % region</source>
        <translation>95-%-Bereich</translation>
    </message>
    <message>
        <source>measured, low coherence</source>
        <translation>gemessen, geringe Kohärenz</translation>
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
        <source>Minimum coherence</source>
        <translation>Mindestkohärenz</translation>
    </message>
    <message>
        <source>Enter the number again</source>
        <translation>Zahl erneut eingeben</translation>
    </message>
    <message>
        <source>maximum safe value</source>
        <translation>größter sicherer Wert</translation>
    </message>
    <message>
        <source>Amplitude of a sine of the same rms in each band. Empty: maximum safe value</source>
        <translation>Amplitude eines Sinus mit gleichem Effektivwert je Band. Leer: größter sicherer Wert</translation>
    </message>
    <message>
        <source>Points below it are shown faint and not used for margins and fit</source>
        <translation>Punkte darunter sind blass und werden für Reserven und Anpassung nicht verwendet</translation>
    </message>
    <message>
        <source>Periods (chirp: sweeps) to average; the intervals shrink with the square root</source>
        <translation>Gemittelte Perioden (Chirp: Durchläufe); die Intervalle schrumpfen mit der Wurzel</translation>
    </message>
    <message>
        <source>Steady speed, at least 3 rad/s in either direction, so that friction acts as a constant offset</source>
        <translation>Stetige Drehzahl, mindestens 3 rad/s in einer der Richtungen; die Reibung wirkt dann als konstanter Versatz</translation>
    </message>
    <message>
        <source>At most 45 % of the position loop&apos;s sampling rate</source>
        <translation>Höchstens 45 % der Abtastrate des Lagekreises</translation>
    </message>
    <message>
        <source>One excitation period lasts four periods of this frequency</source>
        <translation>Eine Periode der Anregung dauert vier Perioden dieser Frequenz</translation>
    </message>
    <message>
        <source>Signal added to the steady motion</source>
        <translation>Signal, das zur stetigen Bewegung addiert wird</translation>
    </message>
    <message>
        <source>chirp: repeated sweeps</source>
        <translation>Chirp: wiederholte Durchläufe</translation>
    </message>
    <message>
        <source>stepped sine: one frequency at a time</source>
        <translation>Stufensinus: eine Frequenz nach der anderen</translation>
    </message>
    <message>
        <source>multisine: all frequencies together</source>
        <translation>Multisinus: alle Frequenzen zugleich</translation>
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
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyPanel</name>
    <message>
        <source>Measurement cancelled. Nothing was changed.</source>
        <translation>Messung abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>Zurück zu den Einstellungen; dieses Ergebnis bleibt bis zum nächsten Lauf</translation>
    </message>
    <message>
        <source>Save the points with error and coherence as CSV</source>
        <translation>Punkte mit Fehler und Kohärenz als CSV speichern</translation>
    </message>
    <message>
        <source>Save a file for Tune and the command line</source>
        <translation>Datei für Auslegung und Kommandozeile speichern</translation>
    </message>
    <message>
        <source>Show the measured points in the open loop of Tune, with the proposed gains</source>
        <translation>Gemessene Punkte im offenen Kreis der Auslegung zeigen, mit den vorgeschlagenen Reglerparametern</translation>
    </message>
    <message>
        <source>The rotor turns steadily and is excited. STOP (Esc) and Cancel end the run. Mode, windows and generator are restored; the gains are not changed.</source>
        <translation>Der Rotor dreht sich stetig und wird angeregt. STOPP (Esc) und Abbrechen beenden den Lauf. Betriebsart, Fenster und Generator werden wiederhergestellt; die Reglerparameter bleiben unverändert.</translation>
    </message>
    <message>
        <source>Measures the loop with the device&apos;s gains over frequency: open loop, plant and margins with 95 % intervals, during a steady motion in one direction.</source>
        <translation>Misst den Kreis mit den Reglerparametern des Geräts über der Frequenz: offener Kreis, Strecke und Reserven mit 95-%-Intervallen, während einer stetigen Bewegung in eine Richtung.</translation>
    </message>
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
        <source>Save response…</source>
        <translation>Frequenzgang speichern …</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>Tabelle speichern …</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
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
        <source>From current to measured angle, with the fitted rotor</source>
        <translation>Vom Strom zum gemessenen Winkel, mit dem angepassten Rotor</translation>
    </message>
    <message>
        <source>With the device&apos;s gains: magnitude, phase and coherence over frequency</source>
        <translation>Mit den Reglerparametern des Geräts: Betrag, Phase und Kohärenz über der Frequenz</translation>
    </message>
    <message>
        <source>Margins and fitted rotor</source>
        <translation>Reserven und angepasster Rotor</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>Offener Kreis</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Strecke</translation>
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
        <source>Maximum current %1 A, maximum coil temperature %2 °C.</source>
        <translation>Größter Strom %1 A, höchste Spulentemperatur %2 °C.</translation>
    </message>
    <message>
        <source>Minimum speed during excitation: %1 rad/s.</source>
        <translation>Kleinste Drehzahl während der Anregung: %1 rad/s.</translation>
    </message>
    <message>
        <source>%1 of %2 frequencies have a coherence of at least %3. The others are shown faint and not used for margins and fit.</source>
        <translation>%1 von %2 Frequenzen haben eine Kohärenz von mindestens %3. Die anderen sind blass und werden für Reserven und Anpassung nicht verwendet.</translation>
    </message>
    <message>
        <source>direct feed-through from current to angle</source>
        <translation>direkter Durchgriff vom Strom auf den Winkel</translation>
    </message>
    <message>
        <source>Device stops at %1 rad/s. The loop is measured with the device&apos;s gains, which are not changed; all other settings are restored.</source>
        <translation>Das Gerät stoppt bei %1 rad/s. Gemessen wird mit den Reglerparametern des Geräts, die unverändert bleiben; alle anderen Einstellungen werden wiederhergestellt.</translation>
    </message>
    <message>
        <source>An excitation of up to %1° is added. The speed keeps its sign; the run stops if it comes near zero.</source>
        <translation>Dazu kommt eine Anregung bis %1°. Die Drehzahl behält ihr Vorzeichen; der Lauf endet, wenn sie nahe null kommt.</translation>
    </message>
    <message>
        <source>at the crossover of %1 Hz</source>
        <translation>am Durchtritt bei %1 Hz</translation>
    </message>
    <message>
        <source>See the findings above for cause and remedy</source>
        <translation>Ursache und Abhilfe siehe Befunde oben</translation>
    </message>
    <message>
        <source>not given: too uncertain</source>
        <translation>nicht angegeben: zu unsicher</translation>
    </message>
    <message>
        <source>not given: crossover in a gap</source>
        <translation>nicht angegeben: Durchtritt in einer Lücke</translation>
    </message>
    <message>
        <source>not given: no crossover</source>
        <translation>nicht angegeben: kein Durchtritt</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>angepasst</translation>
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
        <source>%1 to %2 Hz: amplitude %3°</source>
        <translation>%1 bis %2 Hz: Amplitude %3°</translation>
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
        <source>Parallel: K_P + K_I/s + K_D s. Standard: K (1 + 1/(T_i s) + T_d s). Series: K (1 + 1/(T_i s))(1 + T_d s). Device and files use the parallel form</source>
        <translation>Parallel: K_P + K_I/s + K_D s. Standard: K (1 + 1/(T_i s) + T_d s). Seriell: K (1 + 1/(T_i s))(1 + T_d s). Gerät und Dateien verwenden die parallele Form</translation>
    </message>
    <message>
        <source>Show the feed-forward gains</source>
        <translation>Reglerparameter der Vorsteuerung zeigen</translation>
    </message>
    <message>
        <source>1 A/° = 57.3 A/rad. Files and device use A/rad</source>
        <translation>1 A/° = 57,3 A/rad. Dateien und Gerät verwenden A/rad</translation>
    </message>
    <message>
        <source>%1 of the device</source>
        <translation>%1 des Geräts</translation>
    </message>
    <message>
        <source>Enter zero or a positive number</source>
        <translation>Null oder eine positive Zahl eingeben</translation>
    </message>
    <message>
        <source>missing number</source>
        <translation>fehlende Zahl</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
        <source>Friction assist</source>
        <translation>Reibungshilfe</translation>
    </message>
    <message>
        <source>Unit of the gains</source>
        <translation>Einheit der Reglerparameter</translation>
    </message>
    <message>
        <source>Feed-forward and friction assist</source>
        <translation>Vorsteuerung und Reibungshilfe</translation>
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
        <source>Full friction feed-forward from</source>
        <translation>Volle Reibungsvorsteuerung ab</translation>
    </message>
    <message>
        <source>Friction assist from an error of</source>
        <translation>Reibungshilfe ab einem Fehler von</translation>
    </message>
    <message>
        <source>Friction assist below a speed of</source>
        <translation>Reibungshilfe unter einer Geschwindigkeit von</translation>
    </message>
</context>
<context>
    <name>halbench::app::HelpWindow</name>
    <message>
        <source>Close the help (Ctrl+W; Esc only when disarmed and idle)</source>
        <translation>Hilfe schließen (Strg+W; Esc nur, wenn gesperrt und kein Ablauf läuft)</translation>
    </message>
    <message>
        <source>This page is available in English only.</source>
        <translation>Diese Seite ist nur auf Englisch verfügbar.</translation>
    </message>
    <message>
        <source>Previous page (Alt+Left)</source>
        <translation>Vorige Seite (Alt+Links)</translation>
    </message>
    <message>
        <source>Help page &apos;%1&apos; not found.</source>
        <translation>Hilfeseite „%1“ nicht gefunden.</translation>
    </message>
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
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentificationFigures</name>
    <message>
        <source>Joint 95 % confidence region of damping and friction</source>
        <translation>Gemeinsamer 95-%-Vertrauensbereich von Dämpfung und Reibung</translation>
    </message>
    <message>
        <source>fit forward</source>
        <translation>Gerade vorwärts</translation>
    </message>
    <message>
        <source>fit reverse</source>
        <translation>Gerade rückwärts</translation>
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
        <source>Increase this value or reduce the other</source>
        <translation>Diesen Wert vergrößern oder den anderen verkleinern</translation>
    </message>
    <message>
        <source>Smaller than &quot;%1&quot;.</source>
        <translation>Kleiner als „%1“.</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not valid. %3 Reset to %4 A.</source>
        <translation>%1: „%2“ ist ungültig. %3 Zurückgesetzt auf %4 A.</translation>
    </message>
    <message>
        <source>Show rarely used settings (Alt+A)</source>
        <translation>Selten gebrauchte Einstellungen zeigen (Alt+E)</translation>
    </message>
    <message>
        <source>Seed for plateau order and resampling; equal seeds give equal results</source>
        <translation>Startwert für Plateaureihenfolge und Resampling; gleiche Startwerte geben gleiche Ergebnisse</translation>
    </message>
    <message>
        <source>Known torque constant. Empty: unknown</source>
        <translation>Bekannte Drehmomentkonstante. Leer: unbekannt</translation>
    </message>
    <message>
        <source>Known Coulomb friction. Empty: unknown</source>
        <translation>Bekannte Coulomb-Reibung. Leer: unbekannt</translation>
    </message>
    <message>
        <source>Known viscous damping. Empty: unknown</source>
        <translation>Bekannte viskose Dämpfung. Leer: unbekannt</translation>
    </message>
    <message>
        <source>Known inertia of all rotating parts, for absolute values. Empty: unknown</source>
        <translation>Bekanntes Trägheitsmoment aller drehenden Teile, für absolute Werte. Leer: unbekannt</translation>
    </message>
    <message>
        <source>Both directions also show the asymmetry of friction</source>
        <translation>Beide Richtungen zeigen auch die Unsymmetrie der Reibung</translation>
    </message>
    <message>
        <source>Increment of the current</source>
        <translation>Schrittweite des Stroms</translation>
    </message>
    <message>
        <source>Last current of the sweep</source>
        <translation>Letzter Strom der Messreihe</translation>
    </message>
    <message>
        <source>First current of the sweep; well above the breakaway current</source>
        <translation>Erster Strom der Messreihe; deutlich über dem Losbrechstrom</translation>
    </message>
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
        <source>Given torque constant φ</source>
        <translation>Bekannte Drehmomentkonstante φ</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Startwert</translation>
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
        <source>Advanced settings</source>
        <translation>Erweiterte Einstellungen</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>Berichtigen Sie es, oder lassen Sie es leer</translation>
    </message>
    <message>
        <source>Correct the number</source>
        <translation>Berichtigen Sie die Zahl</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Given friction K&lt;sub&gt;f&lt;/sub&gt;</source>
        <translation>Bekannte Reibung K&lt;sub&gt;f&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>Current to&amp;lerance</source>
        <translation>Stromto&amp;leranz</translation>
    </message>
    <message>
        <source>Limit of the drive&apos;s gain error, in per cent of the current. Empty: the published drive, 0.15 % at one sigma</source>
        <translation>Grenze des Verstärkungsfehlers des Antriebs, in Prozent des Stroms. Leer: der veröffentlichte Antrieb, 0,15 % bei einem Sigma</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyPanel</name>
    <message>
        <source>Identify again if the motor has changed.</source>
        <translation>Neu identifizieren, falls sich der Motor verändert hat.</translation>
    </message>
    <message>
        <source>Identification cancelled. Nothing was changed.</source>
        <translation>Identifikation abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Fitting the recorded motion</source>
        <translation>Aufgezeichnete Bewegung wird angepasst</translation>
    </message>
    <message>
        <source>Rotor turning: plateaus and coast-downs</source>
        <translation>Rotor dreht sich: Plateaus und Ausläufe</translation>
    </message>
    <message>
        <source>Plateaus completed so far; the fit follows at the end</source>
        <translation>Bisher fertige Plateaus; die Anpassung folgt am Ende</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>Zurück zu den Einstellungen; dieses Ergebnis bleibt bis zum nächsten Lauf</translation>
    </message>
    <message>
        <source>Save a file for the commands tune and analyse</source>
        <translation>Datei für die Befehle tune und analyse speichern</translation>
    </message>
    <message>
        <source>Design gains for this motor</source>
        <translation>Reglerparameter für diesen Motor entwerfen</translation>
    </message>
    <message>
        <source>Tune with this model</source>
        <translation>Mit diesem Modell auslegen</translation>
    </message>
    <message>
        <source>Show a saved model</source>
        <translation>Gespeichertes Modell zeigen</translation>
    </message>
    <message>
        <source>Measures damping, friction, torque constant and inertia with 95 % intervals, from steady currents and coast-downs.</source>
        <translation>Misst Dämpfung, Reibung, Drehmomentkonstante und Trägheitsmoment mit 95-%-Intervallen, aus konstanten Strömen und Ausläufen.</translation>
    </message>
    <message>
        <source>Assess</source>
        <translation>Beurteilen</translation>
    </message>
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
        <source>Result</source>
        <translation>Ergebnis</translation>
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
        <source>Save as model…</source>
        <translation>Als Modell speichern …</translation>
    </message>
    <message>
        <source>Identify again</source>
        <translation>Neu identifizieren</translation>
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
        <source>Load model</source>
        <translation>Modell laden</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyResultView</name>
    <message>
        <source>Joint 95 % confidence region of damping and friction</source>
        <translation>Gemeinsamer 95-%-Vertrauensbereich von Dämpfung und Reibung</translation>
    </message>
    <message>
        <source>Steady speed over current, and residuals</source>
        <translation>Stationäre Drehzahl über dem Strom, und Residuen</translation>
    </message>
    <message>
        <source>Confidence region</source>
        <translation>Vertrauensbereich</translation>
    </message>
    <message>
        <source>Identified values</source>
        <translation>Identifizierte Werte</translation>
    </message>
    <message>
        <source>Fit and residuals</source>
        <translation>Anpassung und Residuen</translation>
    </message>
    <message>
        <source>Pictures of the identification</source>
        <translation>Bilder der Identifikation</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyWords</name>
    <message>
        <source>Good; see the remarks below</source>
        <translation>Gut; Anmerkungen unten beachten</translation>
    </message>
    <message>
        <source>Another device is connected: %1.</source>
        <translation>Ein anderes Gerät ist verbunden: %1.</translation>
    </message>
    <message>
        <source>Same as the connected device.</source>
        <translation>Entspricht dem verbundenen Gerät.</translation>
    </message>
    <message>
        <source>No device is connected for comparison.</source>
        <translation>Zum Vergleich ist kein Gerät verbunden.</translation>
    </message>
    <message>
        <source>K_f/φ is the friction current during rotation. Calibrate gives another figure: the breakaway current from rest, usually more.</source>
        <translation>K_f/φ ist der Reibungsstrom während der Drehung. „Kalibrieren“ liefert eine andere Größe: den Losbrechstrom aus dem Stillstand, meist größer.</translation>
    </message>
    <message>
        <source>Without inertia J or torque constant φ only ratios are identified; that is sufficient for tuning.</source>
        <translation>Ohne Trägheitsmoment J oder Drehmomentkonstante φ werden nur Verhältnisse identifiziert; für die Auslegung genügt das.</translation>
    </message>
    <message>
        <source>unknown device</source>
        <translation>unbekanntes Gerät</translation>
    </message>
    <message>
        <source>Unknown device</source>
        <translation>Unbekanntes Gerät</translation>
    </message>
    <message>
        <source>Not required for tuning: the ratios are sufficient.</source>
        <translation>Für die Auslegung nicht nötig: Die Verhältnisse genügen.</translation>
    </message>
    <message>
        <source>• run-ups and coast-downs besides the plateaus: then J or φ is sufficient</source>
        <translation>• Hoch- und Ausläufe zusätzlich zu den Plateaus: dann genügt J oder φ</translation>
    </message>
    <message>
        <source>• torque constant φ (data sheet): gives c and K_f, not J</source>
        <translation>• Drehmomentkonstante φ (Datenblatt): ergibt c und K_f, nicht J</translation>
    </message>
    <message>
        <source>• without data: fix a part of known inertia to the rotor and identify again</source>
        <translation>• ohne Daten: ein Teil bekannter Trägheit am Rotor befestigen und neu identifizieren</translation>
    </message>
    <message>
        <source>• torque constant φ (data sheet): gives J, c and K_f</source>
        <translation>• Drehmomentkonstante φ (Datenblatt): ergibt J, c und K_f</translation>
    </message>
    <message>
        <source>• inertia J of all rotating parts (drawing or weighing): gives c, K_f and φ</source>
        <translation>• Trägheitsmoment J aller drehenden Teile (Zeichnung oder Wägung): ergibt c, K_f und φ</translation>
    </message>
    <message>
        <source>Not identifiable: %1. Angle and current give only ratios. To get the scale, provide one of:</source>
        <translation>Nicht identifizierbar: %1. Winkel und Strom ergeben nur Verhältnisse. Für den Maßstab eines davon angeben:</translation>
    </message>
    <message>
        <source>Rejected: no reliable result</source>
        <translation>Abgelehnt: kein verlässliches Ergebnis</translation>
    </message>
    <message>
        <source>Doubtful: check the findings first</source>
        <translation>Zweifelhaft: zuerst die Befunde prüfen</translation>
    </message>
    <message>
        <source>Good: the model fits the data</source>
        <translation>Gut: Das Modell passt zu den Daten</translation>
    </message>
    <message>
        <source>Current up to %1 A. The run pauses for cooling if the coils come near %2 °C.</source>
        <translation>Strom bis %1 A. Der Lauf pausiert zum Abkühlen, wenn die Spulen nahe %2 °C kommen.</translation>
    </message>
    <message>
        <source>Maximum current %1 A, maximum coil temperature %2 °C.</source>
        <translation>Größter Strom %1 A, höchste Spulentemperatur %2 °C.</translation>
    </message>
    <message>
        <source>both directions</source>
        <translation>in beide Richtungen</translation>
    </message>
    <message>
        <source>Angle and current give only ratios; see below for the missing scale</source>
        <translation>Winkel und Strom ergeben nur Verhältnisse; der fehlende Maßstab steht unten</translation>
    </message>
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
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>in reverse</source>
        <translation>rückwärts</translation>
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
        <source>Device %1, firmware %2</source>
        <translation>Gerät %1, Firmware %2</translation>
    </message>
    <message>
        <source>overrides %1</source>
        <translation>Abweichungen %1</translation>
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
        <source>From the project: identified in virtual time, device %1.</source>
        <translation>Aus dem Projekt: in virtueller Zeit identifiziert, Gerät %1.</translation>
    </message>
    <message>
        <source>From the project: identified %1, device %2.</source>
        <translation>Aus dem Projekt: identifiziert %1, Gerät %2.</translation>
    </message>
    <message>
        <source>K_f/φ, friction as a current</source>
        <translation>K_f/φ, Reibung als Strom</translation>
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
        <source>The rotor will turn %1, about %2 turns in all, at up to %3, for %4 minutes of device time.</source>
        <translation>Der Rotor dreht sich %1, insgesamt etwa %2 Umdrehungen, mit bis zu %3, %4 Minuten Gerätezeit lang.</translation>
    </message>
    <message>
        <source>Device stops at %1. Gains and limits are always restored.</source>
        <translation>Das Gerät stoppt bei %1. Reglerparameter und Grenzwerte werden immer wiederhergestellt.</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportForm</name>
    <message>
        <source>Enter the sampling rate in rows per second.</source>
        <translation>Abtastrate in Zeilen je Sekunde eingeben.</translation>
    </message>
    <message>
        <source>none: use a fixed sampling rate</source>
        <translation>keine: feste Abtastrate verwenden</translation>
    </message>
    <message>
        <source>Sampling rate in rows per second</source>
        <translation>Abtastrate in Zeilen je Sekunde</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>Time column, or sampling rate in rows per second</source>
        <translation>Zeitspalte, oder Abtastrate in Zeilen je Sekunde</translation>
    </message>
    <message>
        <source>Lines above the numbers</source>
        <translation>Zeilen über den Zahlen</translation>
    </message>
    <message>
        <source>Character before the decimals of a number</source>
        <translation>Zeichen vor den Nachkommastellen</translation>
    </message>
    <message>
        <source>space</source>
        <translation>Leerzeichen</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>Character between the columns</source>
        <translation>Zeichen zwischen den Spalten</translation>
    </message>
    <message>
        <source>detected: %1</source>
        <translation>erkannt: %1</translation>
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
        <source>comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>Semikolon</translation>
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
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Header</source>
        <translation>Kopfzeilen</translation>
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
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportTable</name>
    <message>
        <source>Unit of the numbers, e.g. rpm or mA; hyphen: no unit</source>
        <translation>Einheit der Zahlen, z. B. rpm oder mA; Bindestrich: keine Einheit</translation>
    </message>
    <message>
        <source>Signal name of this column in the recording (F2 edits)</source>
        <translation>Signalname dieser Spalte in der Aufzeichnung (F2 bearbeitet)</translation>
    </message>
    <message>
        <source>Choose the time column above</source>
        <translation>Zeitspalte oben wählen</translation>
    </message>
    <message>
        <source>First rows in the units of the recording, with the signal name of each column above</source>
        <translation>Erste Zeilen in den Einheiten der Aufzeichnung, darüber der Signalname jeder Spalte</translation>
    </message>
    <message>
        <source>Preview of the first rows</source>
        <translation>Vorschau der ersten Zeilen</translation>
    </message>
    <message>
        <source>Set by you. Clear it (Delete) to use the value found in the table</source>
        <translation>Von Ihnen gesetzt. Leeren (Entf), um den Wert aus der Tabelle zu verwenden</translation>
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
        <source>Unit of column %1</source>
        <translation>Einheit der Spalte %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportView</name>
    <message>
        <source>A recording of this name exists already.</source>
        <translation>Eine Aufzeichnung dieses Namens existiert bereits.</translation>
    </message>
    <message>
        <source>Enter a name without a folder for the recording.</source>
        <translation>Namen ohne Ordner für die Aufzeichnung eingeben.</translation>
    </message>
    <message>
        <source>Answer above: %1.</source>
        <translation>Oben beantworten: %1.</translation>
    </message>
    <message>
        <source>The file cannot be read with these settings; see the cause above.</source>
        <translation>Die Datei ist mit diesen Einstellungen nicht lesbar; Ursache siehe oben.</translation>
    </message>
    <message>
        <source>Reading the file.</source>
        <translation>Datei wird gelesen.</translation>
    </message>
    <message>
        <source>Choose a file first. Uncertain settings are asked for here.</source>
        <translation>Zuerst eine Datei wählen. Unsichere Einstellungen werden hier abgefragt.</translation>
    </message>
    <message>
        <source>Choose file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Missing for the import</source>
        <translation>Fehlt zum Import</translation>
    </message>
    <message>
        <source>Read all rows, save them as a recording and show it</source>
        <translation>Alle Zeilen lesen, als Aufzeichnung speichern und zeigen</translation>
    </message>
    <message>
        <source>Name of the new recording in the recordings folder</source>
        <translation>Name der neuen Aufzeichnung im Aufzeichnungsordner</translation>
    </message>
    <message>
        <source>File to import</source>
        <translation>Zu importierende Datei</translation>
    </message>
    <message>
        <source>Choose a data file of another program (Ctrl+I in the window)</source>
        <translation>Datendatei eines anderen Programms wählen (Strg+I im Fenster)</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>Name of the recording</source>
        <translation>Name der Aufzeichnung</translation>
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
        <source>Table (*.csv *.txt *.tsv *.dat);;All files (*)</source>
        <translation>Tabelle (*.csv *.txt *.tsv *.dat);;Alle Dateien (*)</translation>
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
        <source>Choose the time column or enter the sampling rate above. If the rows are out of order, sort the file.</source>
        <translation>Zeitspalte wählen oder Abtastrate oben eingeben. Sind die Zeilen ungeordnet, die Datei sortieren.</translation>
    </message>
    <message>
        <source>Change the column&apos;s name or unit below, or choose another time column above.</source>
        <translation>Name oder Einheit der Spalte unten ändern, oder oben eine andere Zeitspalte wählen.</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>Erste Zeilen der Datei</translation>
    </message>
    <message>
        <source>The file does not tell. Choose before importing</source>
        <translation>Aus der Datei nicht erkennbar. Vor dem Import wählen</translation>
    </message>
    <message>
        <source>Uncertain: %1</source>
        <translation>Unsicher: %1</translation>
    </message>
    <message>
        <source>%1; read as %2</source>
        <translation>%1; gelesen als %2</translation>
    </message>
    <message>
        <source>unit of its numbers: %1</source>
        <translation>Einheit ihrer Zahlen: %1</translation>
    </message>
    <message>
        <source>none: fixed sampling rate</source>
        <translation>keine: feste Abtastrate</translation>
    </message>
    <message>
        <source>time column</source>
        <translation>Zeitspalte</translation>
    </message>
    <message>
        <source>meaning of the first lines</source>
        <translation>Bedeutung der ersten Zeilen</translation>
    </message>
    <message>
        <source>format of columns and numbers</source>
        <translation>Format von Spalten und Zahlen</translation>
    </message>
    <message>
        <source>Set separator, decimal sign, header and time above to match the file, or correct the file.</source>
        <translation>Trennzeichen, Dezimalzeichen, Kopfzeilen und Zeit oben passend zur Datei einstellen, oder die Datei berichtigen.</translation>
    </message>
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
        <source>Please choose</source>
        <translation>Bitte wählen</translation>
    </message>
</context>
<context>
    <name>halbench::app::JogRow</name>
    <message>
        <source>Current while a button is held</source>
        <translation>Strom, solange eine Taste gedrückt ist</translation>
    </message>
    <message>
        <source>Speed while a button is held</source>
        <translation>Geschwindigkeit, solange eine Taste gedrückt ist</translation>
    </message>
    <message>
        <source>Moves forward while held (hold Space)</source>
        <translation>Bewegt sich vorwärts, solange gedrückt (Leertaste halten)</translation>
    </message>
    <message>
        <source>Moves backward while held (hold Space)</source>
        <translation>Bewegt sich rückwärts, solange gedrückt (Leertaste halten)</translation>
    </message>
    <message>
        <source>− Back</source>
        <translation>− Zurück</translation>
    </message>
    <message>
        <source>Forward +</source>
        <translation>Vor +</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>Tippdrehzahl</translation>
    </message>
    <message>
        <source>Jog current</source>
        <translation>Tippstrom</translation>
    </message>
</context>
<context>
    <name>halbench::app::LinkPanel</name>
    <message>
        <source>link: %1 packets/s, %2 lost, %3 damaged, %4 ms (max. %5 ms)</source>
        <translation>Verbindung: %1 Pakete/s, %2 verloren, %3 beschädigt, %4 ms (max. %5 ms)</translation>
    </message>
    <message>
        <source>Packets per second (device time), lost, damaged, response time median and maximum</source>
        <translation>Pakete je Sekunde (Gerätezeit), verlorene, beschädigte, Antwortzeit Median und Maximum</translation>
    </message>
    <message>
        <source>Link statistics</source>
        <translation>Statistik der Verbindung</translation>
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
        <source>link: lost, reconnecting</source>
        <translation>Verbindung: verloren, wird wiederhergestellt</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Unfold or fold the log (F9)</source>
        <translation>Protokoll auf- oder zuklappen (F9)</translation>
    </message>
    <message>
        <source>Last message of the log</source>
        <translation>Letzte Meldung des Protokolls</translation>
    </message>
    <message>
        <source>Signals sent to the plots</source>
        <translation>An die Diagramme gesendete Signale</translation>
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
        <source>time advances only during a procedure</source>
        <translation>Zeit läuft nur während eines Ablaufs</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s), %1 Hz, samples lost: %2</source>
        <translation>
            <numerusform>%n Signal, %1 Hz, verlorene Messwerte: %2</numerusform>
            <numerusform>%n Signale, %1 Hz, verlorene Messwerte: %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::LiveHall</name>
    <message>
        <source>Field measured by the Hall sensors</source>
        <translation>Von den Hall-Sensoren gemessenes Feld</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>Hall B</translation>
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
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>done, good</source>
        <translation>fertig, gut</translation>
    </message>
    <message>
        <source>done, doubtful</source>
        <translation>fertig, zweifelhaft</translation>
    </message>
    <message>
        <source>done, rejected</source>
        <translation>fertig, abgelehnt</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>ended: %1</source>
        <translation>beendet: %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopCapture</name>
    <message>
        <source>Device lost before its capture settings were restored. Unless it was restarted, the settings of the last capture are still active</source>
        <translation>Gerät verloren, bevor seine Erfassungseinstellungen zurückgestellt wurden. Ohne Neustart gelten noch die der letzten Erfassung</translation>
    </message>
    <message>
        <source>capture</source>
        <translation>Erfassung</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopFigures</name>
    <message>
        <source>measured, low coherence</source>
        <translation>gemessen, geringe Kohärenz</translation>
    </message>
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
</context>
<context>
    <name>halbench::app::LoopSliders</name>
    <message>
        <source>Requested %1; set to the nearest possible value.</source>
        <translation>Angefordert %1; auf den nächsten möglichen Wert gesetzt.</translation>
    </message>
    <message>
        <source>Limited to %1 (gain margin %2).</source>
        <translation>Begrenzt auf %1 (Amplitudenreserve %2).</translation>
    </message>
    <message>
        <source>Limited to %1 (K_P would become zero).</source>
        <translation>Begrenzt auf %1 (K_P würde null).</translation>
    </message>
    <message>
        <source>Limited to %1 (K_D would become negative).</source>
        <translation>Begrenzt auf %1 (K_D würde negativ).</translation>
    </message>
    <message>
        <source>Limited to %1 (end of range).</source>
        <translation>Begrenzt auf %1 (Ende des Bereichs).</translation>
    </message>
    <message>
        <source>Phase margin at the present crossover. Arrow keys: 1°, Page Up/Down: 5°</source>
        <translation>Phasenreserve bei der jetzigen Durchtrittsfrequenz. Pfeiltasten: 1°, Bild auf/ab: 5°</translation>
    </message>
    <message>
        <source>Gain crossover: closed-loop bandwidth; the phase margin is kept if possible. Arrow keys: 2 %, Page Up/Down: 25 %</source>
        <translation>Durchtrittsfrequenz: Bandbreite des Kreises; die Phasenreserve bleibt, wenn möglich. Pfeiltasten: 2 %, Bild auf/ab: 25 %</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>Schnelli&amp;gkeit</translation>
    </message>
    <message>
        <source>Speed: gain crossover</source>
        <translation>Schnelligkeit: Durchtrittsfrequenz</translation>
    </message>
    <message>
        <source>&amp;Robustness</source>
        <translation>&amp;Robustheit</translation>
    </message>
    <message>
        <source>Robustness: phase margin</source>
        <translation>Robustheit: Phasenreserve</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopView</name>
    <message>
        <source>Plot the phase between -180° and 180°</source>
        <translation>Phase zwischen -180° und 180° darstellen</translation>
    </message>
    <message>
        <source>Bode: magnitude and phase over frequency. Nyquist: locus around -1. Nichols: magnitude over phase. Sensitivity: disturbance rejection and reference tracking. Root locus: closed-loop poles over the gain</source>
        <translation>Bode: Betrag und Phase über der Frequenz. Nyquist: Ortskurve um -1. Nichols: Betrag über der Phase. Empfindlichkeit: Störunterdrückung und Führungsverhalten. Wurzelortskurve: Pole des geschlossenen Kreises über der Verstärkung</translation>
    </message>
    <message>
        <source>Closed loop unstable: no sensitivity.</source>
        <translation>Geschlossener Kreis instabil: keine Empfindlichkeit.</translation>
    </message>
    <message>
        <source>Open-loop plot</source>
        <translation>Darstellung des offenen Kreises</translation>
    </message>
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
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Root locus</source>
        <translation>Wurzelortskurve</translation>
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
</context>
<context>
    <name>halbench::app::MainWindow</name>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Stop the actuator</source>
        <translation>Aktor stoppen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>by STOP of a dialog</source>
        <translation>durch STOP eines Dialogs</translation>
    </message>
    <message>
        <source>&amp;About Halbench</source>
        <translation>Ü&amp;ber Halbench</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>Open the project to restore it.</source>
        <translation>Projekt öffnen, um sie wiederherzustellen.</translation>
    </message>
    <message>
        <source>Default plots are shown where the project is not valid: %1</source>
        <translation>Standarddiagramme werden gezeigt, wo das Projekt ungültig ist: %1</translation>
    </message>
    <message>
        <source>The running recording keeps its settings.</source>
        <translation>Die laufende Aufzeichnung behält ihre Einstellungen.</translation>
    </message>
    <message>
        <source>The project&apos;s recording settings apply from the next recording on.</source>
        <translation>Die Aufzeichnungseinstellungen des Projekts gelten ab der nächsten Aufzeichnung.</translation>
    </message>
    <message>
        <source>Deletion starts only after you have checked the list in Preferences.</source>
        <translation>Gelöscht wird erst, nachdem Sie die Liste in den Einstellungen geprüft haben.</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of %1 exceed the limits in the preferences and are kept for now.</source>
        <translation>
            <numerusform>%n Aufzeichnung mit %1 überschreitet die Grenzen in den Einstellungen und bleibt vorerst.</numerusform>
            <numerusform>%n Aufzeichnungen mit %1 überschreiten die Grenzen in den Einstellungen und bleiben vorerst.</numerusform>
        </translation>
    </message>
    <message>
        <source>Import da&amp;ta (CSV)…</source>
        <translation>Da&amp;ten importieren (CSV)…</translation>
    </message>
    <message>
        <source>Use them</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>requested %1</source>
        <translation>angefordert %1</translation>
    </message>
    <message>
        <source>by STOP of the help window</source>
        <translation>mit STOPP des Hilfefensters</translation>
    </message>
    <message>
        <source>by STOP of a panel window</source>
        <translation>mit STOPP eines Bereichsfensters</translation>
    </message>
    <message>
        <source>STOP and Esc remain active until then.</source>
        <translation>STOPP und Esc wirken bis dahin.</translation>
    </message>
    <message>
        <source>The program closes after the running task is stopped and the actuator disarmed.</source>
        <translation>Das Programm schließt, sobald die laufende Aufgabe gestoppt und der Aktor gesperrt ist.</translation>
    </message>
    <message>
        <source>Save the project to another place, or close without saving.</source>
        <translation>Projekt an anderer Stelle speichern oder ohne Speichern schließen.</translation>
    </message>
    <message>
        <source>The window stays open because of unsaved work.</source>
        <translation>Das Fenster bleibt offen, weil ungespeicherte Arbeit vorliegt.</translation>
    </message>
    <message>
        <source>The project&apos;s autosave could not be read; it was moved to %1.</source>
        <translation>Die automatische Sicherung des Projekts war nicht lesbar; sie liegt unter %1.</translation>
    </message>
    <message>
        <source>Close it there, or open a copy as a new project.</source>
        <translation>Dort schließen, oder eine Kopie als neues Projekt öffnen.</translation>
    </message>
    <message>
        <source>They stay in the file unchanged; the rest is open.</source>
        <translation>Sie bleiben unverändert in der Datei; der Rest ist geöffnet.</translation>
    </message>
    <message>
        <source>Parts of the project could not be read: %1</source>
        <translation>Teile des Projekts waren nicht lesbar: %1</translation>
    </message>
    <message>
        <source>Save it with a name to keep it.</source>
        <translation>Zum Behalten unter einem Namen speichern.</translation>
    </message>
    <message>
        <source>Restored your unsaved project.</source>
        <translation>Ihr ungespeichertes Projekt wurde wiederhergestellt.</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>An&amp;ordnung zurücksetzen</translation>
    </message>
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
        <source>unnamed project</source>
        <translation>Projekt ohne Namen</translation>
    </message>
    <message>
        <source>%1[*] — Halbench</source>
        <translation>%1[*] — Halbench</translation>
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
        <source>Open a copy</source>
        <translation>Kopie öffnen</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>Projekt speichern unter …</translation>
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
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>by Esc</source>
        <translation>mit Esc</translation>
    </message>
    <message>
        <source>by STOP</source>
        <translation>mit STOPP</translation>
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
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
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
        <source>The file keeps these lines until the project is saved.</source>
        <translation>Die Datei behält diese Zeilen, bis das Projekt gespeichert wird.</translation>
    </message>
    <message>
        <source>%1 has unsaved work of an earlier session.</source>
        <translation>%1 hat ungespeicherte Arbeit einer früheren Sitzung.</translation>
    </message>
    <message>
        <source>Open the project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>&amp;Plots and STOP only</source>
        <translation>Nur &amp;Diagramme und STOPP</translation>
    </message>
</context>
<context>
    <name>halbench::app::ModeBox</name>
    <message>
        <source>Idle: no current. Current: manual torque. Position: holds and follows.
D-axis: current that holds the rotor without torque (%1)</source>
        <translation>Leerlauf: kein Strom. Strom: Drehmoment von Hand. Position: hält und folgt.
D-Achse: Strom, der den Rotor ohne Drehmoment hält (%1)</translation>
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
</context>
<context>
    <name>halbench::app::MonitorCapture</name>
    <message>
        <source>Stopped after an event (Shift+T re-arms); %1</source>
        <translation>Angehalten nach einem Ereignis (Umschalt+T: neu scharf stellen); %1</translation>
    </message>
    <message>
        <source>Reading the capture from the device, %1 %</source>
        <translation>Erfassung wird aus dem Gerät gelesen, %1 %</translation>
    </message>
    <message>
        <source>Reading, %1 %</source>
        <translation>Wird gelesen, %1 %</translation>
    </message>
    <message>
        <source>Captured; read from the device after the recording, so that no sample is lost</source>
        <translation>Erfasst; wird nach der Aufzeichnung ausgelesen, damit kein Messwert verloren geht</translation>
    </message>
    <message>
        <source>Captured</source>
        <translation>Erfasst</translation>
    </message>
    <message>
        <source>Triggered; capturing the time after the event</source>
        <translation>Ausgelöst; die Zeit nach dem Ereignis wird erfasst</translation>
    </message>
    <message>
        <source>Waiting until %1; captures %2</source>
        <translation>Wartet, bis %1; erfasst %2</translation>
    </message>
    <message>
        <source>Capturing the time before the event: %1</source>
        <translation>Zeit vor dem Ereignis wird erfasst: %1</translation>
    </message>
    <message>
        <source>Filling pre-trigger</source>
        <translation>Vortrigger füllt sich</translation>
    </message>
    <message>
        <source>Setting up the capture of %1</source>
        <translation>Erfassung von %1 wird eingerichtet</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Startet</translation>
    </message>
    <message>
        <source>A procedure is using the device; the capture continues afterwards</source>
        <translation>Ein Ablauf nutzt das Gerät; die Erfassung läuft danach weiter</translation>
    </message>
    <message>
        <source>On hold</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>%1 at %2 Hz, %3 s, starting %4 s before the event</source>
        <translation>%1 mit %2 Hz, %3 s, ab %4 s vor dem Ereignis</translation>
    </message>
    <message>
        <source>This device has no capture function.</source>
        <translation>Dieses Gerät hat keine Erfassungsfunktion.</translation>
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
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorData</name>
    <message>
        <source>; not included (other time axis): %1</source>
        <translation>; nicht enthalten (andere Zeitachse): %1</translation>
    </message>
    <message>
        <source>Save the samples in view or between the cursors (CSV, MDF4, MAT)</source>
        <translation>Messwerte im Bild oder zwischen den Cursorn speichern (CSV, MDF4, MAT)</translation>
    </message>
    <message>
        <source>Copy the samples in view or between the cursors as a table</source>
        <translation>Messwerte im Bild oder zwischen den Cursorn als Tabelle kopieren</translation>
    </message>
    <message>
        <source>Copy data</source>
        <translation>Daten kopieren</translation>
    </message>
    <message>
        <source>Save data…</source>
        <translation>Daten speichern …</translation>
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
</context>
<context>
    <name>halbench::app::MonitorForecast</name>
    <message>
        <source>Time until the coil limit is reached</source>
        <translation>Zeit bis zum Spulengrenzwert</translation>
    </message>
    <message>
        <source>Time to %1: %2.</source>
        <translation>Zeit bis %1: %2.</translation>
    </message>
    <message>
        <source>%1 stays below %2 for %3 at this load; final value not known yet.</source>
        <translation>%1 bleibt bei dieser Last %3 lang unter %2; Endwert noch nicht bekannt.</translation>
    </message>
    <message>
        <source>%1 stays below %2 at this load.</source>
        <translation>%1 bleibt bei dieser Last unter %2.</translation>
    </message>
    <message>
        <source>%1 stays below %2 at this load: final value %3 to %4 °C.</source>
        <translation>%1 bleibt bei dieser Last unter %2: Endwert %3 bis %4 °C.</translation>
    </message>
    <message>
        <source>%1 reaches %2 at this load in %3 (95 %: %4 to %5).</source>
        <translation>%1 erreicht %2 bei dieser Last in %3 (95 %: %4 bis %5).</translation>
    </message>
    <message>
        <source>temperature does not follow a steady load</source>
        <translation>Temperatur passt nicht zu gleichbleibender Last</translation>
    </message>
    <message>
        <source>temperature change below the sensor&apos;s resolution</source>
        <translation>Temperaturänderung unter der Sensorauflösung</translation>
    </message>
    <message>
        <source>needs %2 s of steady load (%1 s so far)</source>
        <translation>braucht %2 s gleichbleibende Last (bisher %1 s)</translation>
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
        <source>%1 is at its limit of %2.</source>
        <translation>%1 ist an ihrem Grenzwert von %2.</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorPanel</name>
    <message>
        <source>The data shown may differ from the data recorded.</source>
        <translation>Die gezeigten Daten können von den aufgezeichneten abweichen.</translation>
    </message>
    <message>
        <source>The units of the preferences are used. Choose others in the legend (U). The project keeps its entries until you change the plots.</source>
        <translation>Die Einheiten der Einstellungen werden verwendet. Andere in der Legende wählen (U). Das Projekt behält seine Einträge, bis Sie die Diagramme ändern.</translation>
    </message>
    <message>
        <source>Units of the project that do not fit the signals: %1</source>
        <translation>Einheiten des Projekts, die nicht zu den Signalen passen: %1</translation>
    </message>
    <message>
        <source>Plot the selected signal (Insert)</source>
        <translation>Gewähltes Signal darstellen (Einfg)</translation>
    </message>
    <message>
        <source>Markers not saved: %1</source>
        <translation>Marken nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>They are added after the recording, so that the recording has no gap.</source>
        <translation>Sie werden nach der Aufzeichnung hinzugefügt, damit die Aufzeichnung keine Lücke hat.</translation>
    </message>
    <message>
        <source>These signals are sampled at other events than the others. Plot only signals of the same event together.</source>
        <translation>Diese Signale werden zu anderen Ereignissen abgetastet als die übrigen. Nur Signale desselben Ereignisses gemeinsam darstellen.</translation>
    </message>
    <message>
        <source>Connect a device to see live data: choose one on the left, or try the simulated motor.</source>
        <translation>Für Live-Daten ein Gerät verbinden: links wählen oder den simulierten Motor ausprobieren.</translation>
    </message>
    <message>
        <source>No live data</source>
        <translation>Keine Live-Daten</translation>
    </message>
    <message>
        <source>They are not plotted. The project keeps them until you change the plots.</source>
        <translation>Sie werden nicht dargestellt. Das Projekt behält sie, bis Sie die Diagramme ändern.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Weitere Werkzeuge</translation>
    </message>
    <message>
        <source>Signals of the project that this device does not have: %1</source>
        <translation>Signale des Projekts, die dieses Gerät nicht hat: %1</translation>
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
        <source>Not in the running recording: %1</source>
        <translation>Nicht in der laufenden Aufzeichnung: %1</translation>
    </message>
    <message>
        <source>Plot fewer signals.</source>
        <translation>Weniger Signale darstellen.</translation>
    </message>
    <message>
        <source>Signal to plot</source>
        <translation>Zu zeichnendes Signal</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorPicture</name>
    <message>
        <source>Off: light background for paper and documents</source>
        <translation>Aus: heller Hintergrund für Papier und Dokumente</translation>
    </message>
    <message>
        <source>Pictures in window colours</source>
        <translation>Bilder in Fensterfarben</translation>
    </message>
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
        <translation>Diagramme als Bild kopieren</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Save the plots as SVG, PDF or PNG</source>
        <translation>Diagramme als SVG, PDF oder PNG speichern</translation>
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
</context>
<context>
    <name>halbench::app::MonitorRate</name>
    <message>
        <source>Maximum of device and link</source>
        <translation>Maximum von Gerät und Verbindung</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Default (%1)</source>
        <translation>Vorgabe (%1)</translation>
    </message>
    <message>
        <source>%1 is not possible for the plotted signals; %2 is used, the maximum of device and link.</source>
        <translation>%1 ist für die dargestellten Signale nicht möglich; verwendet wird %2, das Maximum von Gerät und Verbindung.</translation>
    </message>
    <message>
        <source>Sample rate of the plots, limited by device and link</source>
        <translation>Abtastrate der Diagramme, begrenzt durch Gerät und Verbindung</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Live rate</source>
        <translation>Live-Rate</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorRecording</name>
    <message>
        <source>Markers not saved: %1</source>
        <translation>Marken nicht gespeichert: %1</translation>
    </message>
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
</context>
<context>
    <name>halbench::app::MonitorReference</name>
    <message>
        <source>Reference curves: keep the view (K), a recording (Ctrl+K), none (Shift+K)</source>
        <translation>Referenzkurven: Ansicht behalten (K), Aufzeichnung (Strg+K), keine (Umschalt+K)</translation>
    </message>
    <message>
        <source>Recording as reference</source>
        <translation>Aufzeichnung als Referenz</translation>
    </message>
    <message>
        <source>Show a recording below the curves, aligned at trigger or start</source>
        <translation>Aufzeichnung unter den Kurven zeigen, an Trigger oder Beginn ausgerichtet</translation>
    </message>
    <message>
        <source>Recording as reference…</source>
        <translation>Aufzeichnung als Referenz …</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4)</source>
        <translation>Aufzeichnung (*.csv *.mf4)</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorStatistics</name>
    <message>
        <source>Visible range of each plot</source>
        <translation>Sichtbarer Bereich jedes Diagramms</translation>
    </message>
    <message>
        <source>Minimum, maximum, mean, rms and standard deviation in view or between cursors (S)</source>
        <translation>Minimum, Maximum, Mittelwert, Effektivwert und Standardabweichung im Bild oder zwischen den Cursorn (S)</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>In view, %1 s</source>
        <translation>Im Bild, %1 s</translation>
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
        <source>Stopped after the event at %1 s (Shift+T re-arms)</source>
        <translation>Angehalten nach dem Ereignis bei %1 s (Umschalt+T: neu scharf stellen)</translation>
    </message>
    <message>
        <source>Auto: no event, free-running; waiting until %1</source>
        <translation>Auto: kein Ereignis, freilaufend; wartet, bis %1</translation>
    </message>
    <message>
        <source>Triggered; filling the window</source>
        <translation>Ausgelöst; Fenster füllt sich</translation>
    </message>
    <message>
        <source>No samples of %1</source>
        <translation>Keine Messwerte von %1</translation>
    </message>
    <message>
        <source>Clear the event and wait for the next one</source>
        <translation>Ereignis löschen und auf das nächste warten</translation>
    </message>
    <message>
        <source>Re-arm trigger</source>
        <translation>Trigger neu scharf stellen</translation>
    </message>
    <message>
        <source>Oscilloscope view: time around the latest event</source>
        <translation>Oszilloskop-Ansicht: Zeit um das letzte Ereignis</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Waiting until %1</source>
        <translation>Wartet, bis %1</translation>
    </message>
    <message>
        <source>Triggered at %1 s; waiting for the next</source>
        <translation>Ausgelöst bei %1 s; wartet auf das nächste</translation>
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
        <source>Notes on this motor; saved with the project</source>
        <translation>Notizen zu diesem Motor; werden mit dem Projekt gespeichert</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Notes on this motor; saved with the project.</source>
        <translation>Notizen zu diesem Motor; werden mit dem Projekt gespeichert.</translation>
    </message>
</context>
<context>
    <name>halbench::app::NumberCheck</name>
    <message>
        <source>Reset to %1.</source>
        <translation>Zurückgesetzt auf %1.</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not valid. No motion started.</source>
        <translation>%1: „%2“ ist ungültig. Keine Bewegung gestartet.</translation>
    </message>
</context>
<context>
    <name>halbench::app::PaceRow</name>
    <message>
        <source>Speed of the simulated motor or of the replay: 20 times runs two minutes in six seconds.
Keys in the Monitor: &lt; and &gt;. A real device always runs in real time.</source>
        <translation>Tempo des simulierten Motors oder der Wiedergabe: 20-fach läuft zwei Minuten in sechs Sekunden ab.
Tasten im Monitor: &lt; und &gt;. Ein echtes Gerät läuft immer in Echtzeit.</translation>
    </message>
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
        <translation>Tempo der simulierten Zeit</translation>
    </message>
</context>
<context>
    <name>halbench::app::PaceSteps</name>
    <message>
        <source>Speed up simulated or replayed time</source>
        <translation>Simulierte oder wiedergegebene Zeit beschleunigen</translation>
    </message>
    <message>
        <source>Slow down simulated or replayed time</source>
        <translation>Simulierte oder wiedergegebene Zeit verlangsamen</translation>
    </message>
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
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
</context>
<context>
    <name>halbench::app::ParametersPanel</name>
    <message>
        <source>Save the values as a preset, or run the device with serve to keep them.</source>
        <translation>Werte als Parametersatz speichern, oder das Gerät mit „serve“ betreiben, um sie zu behalten.</translation>
    </message>
    <message>
        <source>Save the edited column as a preset of this name (Enter in the name)</source>
        <translation>Bearbeitete Spalte als Parametersatz dieses Namens speichern (Eingabetaste im Namen)</translation>
    </message>
    <message>
        <source>Save the edited column as a preset of this name (Enter)</source>
        <translation>Bearbeitete Spalte als Parametersatz dieses Namens speichern (Eingabetaste)</translation>
    </message>
    <message>
        <source>This device cannot write a complete set at once: values were changed one after the other.</source>
        <translation>Dieses Gerät kann keinen ganzen Satz auf einmal schreiben: Werte wurden nacheinander geändert.</translation>
    </message>
    <message>
        <source>The device does not allow writing to them or to its active page.</source>
        <translation>Das Gerät erlaubt für sie oder seine aktive Seite kein Schreiben.</translation>
    </message>
    <message>
        <source>Read-only parameters: %1.</source>
        <translation>Nur lesbare Parameter: %1.</translation>
    </message>
    <message>
        <source>The device lacks these parameters or does not allow these values.</source>
        <translation>Das Gerät hat diese Parameter nicht oder lässt diese Werte nicht zu.</translation>
    </message>
    <message>
        <source>Not loaded from the preset: %1</source>
        <translation>Nicht aus dem Parametersatz geladen: %1</translation>
    </message>
    <message>
        <source>Active from the next power-up on.</source>
        <translation>Gilt ab dem nächsten Einschalten.</translation>
    </message>
    <message>
        <source>Saved to the device.</source>
        <translation>Im Gerät gespeichert.</translation>
    </message>
    <message>
        <source>A simulated device cannot store values: it is reset at each connection.</source>
        <translation>Ein simuliertes Gerät kann nichts speichern: Es wird bei jedem Verbinden zurückgesetzt.</translation>
    </message>
    <message>
        <source>Lost at power-off unless saved to the device.</source>
        <translation>Ohne Speichern im Gerät beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>Save the active values to non-volatile memory for the next power-up</source>
        <translation>Aktive Werte nichtflüchtig für das nächste Einschalten speichern</translation>
    </message>
    <message>
        <source>Save to device</source>
        <translation>Im Gerät speichern</translation>
    </message>
    <message>
        <source>preset name</source>
        <translation>Name des Parametersatzes</translation>
    </message>
    <message>
        <source>Load the preset into the rows; nothing is written yet</source>
        <translation>Parametersatz in die Zeilen laden; noch wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Named set of parameters, built-in or your own</source>
        <translation>Benannter Parametersatz, mitgeliefert oder eigener</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Parametersatz</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Name of the new preset</source>
        <translation>Name des neuen Parametersatzes</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) written and read back.</source>
        <translation>
            <numerusform>%n Wert geschrieben und zurückgelesen.</numerusform>
            <numerusform>%n Werte geschrieben und zurückgelesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>%1 laden</translation>
    </message>
    <message>
        <source>Save preset</source>
        <translation>Satz speichern</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Preset saved as %1.</source>
        <translation>Parametersatz als %1 gespeichert.</translation>
    </message>
</context>
<context>
    <name>halbench::app::PerspectiveBar</name>
    <message>
        <source>Layout for another task (Ctrl+1 to Ctrl+5)</source>
        <translation>Anordnung für eine andere Aufgabe (Strg+1 bis Strg+5)</translation>
    </message>
    <message>
        <source>Layout for %1 (%2)</source>
        <translation>Anordnung für %1 (%2)</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>Ansicht %1</translation>
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
    <name>halbench::app::PosePad</name>
    <message>
        <source>Jog pad</source>
        <translation>Tippfeld</translation>
    </message>
    <message>
        <source>Arrow keys jog the first two axes, Page Up and Page Down the third, while they are held</source>
        <translation>Pfeiltasten tippen die ersten beiden Achsen, Bild auf und Bild ab die dritte, solange sie gehalten werden</translation>
    </message>
    <message>
        <source>Go to pose</source>
        <translation>Zur Lage fahren</translation>
    </message>
    <message>
        <source>Goes to this pose, one axis after the other, as even ramps</source>
        <translation>Fährt zu dieser Lage, eine Achse nach der anderen, als gleichmäßige Rampen</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Hier</translation>
    </message>
    <message>
        <source>Takes the pose where it is now</source>
        <translation>Übernimmt die jetzige Lage</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Referenzieren</translation>
    </message>
    <message>
        <source>Counts the pitch cells from the present one; nothing moves</source>
        <translation>Zählt die Teilungszellen ab der jetzigen; nichts bewegt sich</translation>
    </message>
    <message>
        <source>%1 while it is held (hold Space)</source>
        <translation>%1, solange gehalten (Leertaste halten)</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>Position to go to, absolute</source>
        <translation>Anzufahrende Position, absolut</translation>
    </message>
    <message>
        <source>Jog %1 backward</source>
        <translation>%1 rückwärts tippen</translation>
    </message>
    <message>
        <source>Jog %1 forward</source>
        <translation>%1 vorwärts tippen</translation>
    </message>
    <message>
        <source>The pose is beyond the excursion window of axis %1; nothing more was sent.</source>
        <translation>Die Lage ist außerhalb des Auslenkungsfensters der Achse %1; weiter wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>Widen the window on purpose, or disarm and arm to count anew.</source>
        <translation>Erweitern Sie das Fenster bewusst, oder sperren und geben Sie neu frei, um neu zu zählen.</translation>
    </message>
</context>
<context>
    <name>halbench::app::PreferencesDialog</name>
    <message>
        <source>Unit of the frequency axes; files use Hz</source>
        <translation>Einheit der Frequenzachsen; Dateien verwenden Hz</translation>
    </message>
    <message>
        <source>Present history on disk</source>
        <translation>Verlauf auf dem Datenträger, jetzt</translation>
    </message>
    <message>
        <source>Disk space for samples that do not fit into memory; the oldest are dropped first. 4 GB always stay free. Recordings are not affected</source>
        <translation>Speicherplatz für Messwerte, die nicht in den Arbeitsspeicher passen; die ältesten entfallen zuerst. 4 GB bleiben immer frei. Aufzeichnungen sind nicht betroffen</translation>
    </message>
    <message>
        <source>Maximum history on disk</source>
        <translation>Verlauf auf dem Datenträger, Maximum</translation>
    </message>
    <message>
        <source>Discard the changes (Esc, which also stops)</source>
        <translation>Änderungen verwerfen (Esc, stoppt auch)</translation>
    </message>
    <message>
        <source>Apply the settings (Enter)</source>
        <translation>Einstellungen übernehmen (Eingabe)</translation>
    </message>
    <message>
        <source>Release dela&amp;y after stop</source>
        <translation>Warte&amp;zeit bis zum Aufheben eines Stopps</translation>
    </message>
    <message>
        <source>Minimum time between a stop and its release</source>
        <translation>Mindestzeit zwischen Stopp und Aufheben</translation>
    </message>
    <message>
        <source>Release delay after stop</source>
        <translation>Wartezeit bis zum Aufheben eines Stopps</translation>
    </message>
    <message>
        <source>Unit of displayed speeds; files always use SI units</source>
        <translation>Einheit angezeigter Drehzahlen; Dateien immer in SI-Einheiten</translation>
    </message>
    <message>
        <source>Unit of displayed angles; files always use SI units</source>
        <translation>Einheit angezeigter Winkel; Dateien immer in SI-Einheiten</translation>
    </message>
    <message>
        <source>Language of the window; files are not affected</source>
        <translation>Sprache des Fensters; Dateien sind nicht betroffen</translation>
    </message>
    <message>
        <source>same as system</source>
        <translation>wie das System</translation>
    </message>
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
        <source>&amp;Angles in</source>
        <translation>&amp;Winkel in</translation>
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
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>used: %1 GB</source>
        <translation>belegt: %1 GB</translation>
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
        <source>hertz</source>
        <translation>Hertz</translation>
    </message>
</context>
<context>
    <name>halbench::app::Preflight</name>
    <message>
        <source>The axes may move now</source>
        <translation>Die Achsen dürfen sich jetzt bewegen</translation>
    </message>
    <message>
        <source>A real actuator moves only after your confirmation</source>
        <translation>Ein echter Aktor bewegt sich erst nach Ihrer Bestätigung</translation>
    </message>
    <message>
        <source>A real motor moves only after your confirmation</source>
        <translation>Ein echter Motor bewegt sich erst nach Ihrer Bestätigung</translation>
    </message>
    <message>
        <source>The rotor may turn now</source>
        <translation>Der Rotor darf sich jetzt drehen</translation>
    </message>
    <message>
        <source>Checks before the start</source>
        <translation>Prüfungen vor dem Start</translation>
    </message>
</context>
<context>
    <name>halbench::app::PreflightWords</name>
    <message>
        <source>Every axis is free to move and clear of people</source>
        <translation>Jede Achse ist frei beweglich und niemand ist in Reichweite</translation>
    </message>
    <message>
        <source>Check, then start</source>
        <translation>Prüfen, dann starten</translation>
    </message>
    <message>
        <source>The stop was released just now</source>
        <translation>Der Stopp wurde gerade aufgehoben</translation>
    </message>
    <message>
        <source>Press Release next to the state at the top</source>
        <translation>„Aufheben“ neben dem Zustand oben drücken</translation>
    </message>
    <message>
        <source>Use it by signal and parameter name in Signals, Record and Parameters</source>
        <translation>Nach Signal- und Parameternamen in Signale, Aufnahme und Parameter verwenden</translation>
    </message>
    <message>
        <source>No profile for the motor of this device</source>
        <translation>Kein Profil für den Motor dieses Geräts</translation>
    </message>
    <message>
        <source>Plug it in or switch it on</source>
        <translation>Anstecken oder einschalten</translation>
    </message>
    <message>
        <source>Connection lost, reconnecting</source>
        <translation>Verbindung verloren, wird wiederhergestellt</translation>
    </message>
    <message>
        <source>%1, up to %2 expected</source>
        <translation>%1, bis %2 erwartet</translation>
    </message>
    <message>
        <source>Check, then confirm below</source>
        <translation>Prüfen, dann unten bestätigen</translation>
    </message>
    <message>
        <source>Rotor is free to turn and clear of people</source>
        <translation>Rotor ist frei drehbar, keine Personen in der Nähe</translation>
    </message>
    <message>
        <source>Simulated: no collision possible</source>
        <translation>Simuliert: keine Kollision möglich</translation>
    </message>
    <message>
        <source>Use less current or fewer steps to stay below %1</source>
        <translation>Weniger Strom oder weniger Schritte verwenden, um unter %1 zu bleiben</translation>
    </message>
    <message>
        <source>%1; the run pauses near %2</source>
        <translation>%1; der Lauf pausiert nahe %2</translation>
    </message>
    <message>
        <source>Coil temperature unknown; it is measured first</source>
        <translation>Spulentemperatur unbekannt; wird zuerst gemessen</translation>
    </message>
    <message>
        <source>The device is armed manually</source>
        <translation>Das Gerät ist von Hand freigegeben</translation>
    </message>
    <message>
        <source>Remove the cause, then release the stop in the Drive panel</source>
        <translation>Ursache beseitigen, dann den Stopp im Bereich Antrieb aufheben</translation>
    </message>
    <message>
        <source>Device connected and idle</source>
        <translation>Gerät verbunden und bereit</translation>
    </message>
    <message>
        <source>Wait until it ends, or cancel it</source>
        <translation>Auf sein Ende warten oder ihn abbrechen</translation>
    </message>
    <message>
        <source>Another procedure is running</source>
        <translation>Ein anderer Ablauf läuft</translation>
    </message>
    <message>
        <source>No device is connected</source>
        <translation>Kein Gerät ist verbunden</translation>
    </message>
    <message>
        <source>Connect one in the Devices panel</source>
        <translation>Verbinden Sie eines im Bereich Geräte</translation>
    </message>
    <message>
        <source>Fault: %1</source>
        <translation>Fehler: %1</translation>
    </message>
    <message>
        <source>The stop is latched</source>
        <translation>Der Stopp ist verriegelt</translation>
    </message>
    <message>
        <source>Disarm it first</source>
        <translation>Zuerst sperren</translation>
    </message>
    <message>
        <source>No fault, not stopped, not armed</source>
        <translation>Kein Fehler, nicht gestoppt, nicht freigegeben</translation>
    </message>
    <message>
        <source>Coils %1 now</source>
        <translation>Spulen jetzt %1</translation>
    </message>
    <message>
        <source>No fault, not stopped</source>
        <translation>Kein Fehler, nicht gestoppt</translation>
    </message>
</context>
<context>
    <name>halbench::app::ProjectMenu</name>
    <message>
        <source>Disarm, or wait for the end of the procedure, then open the project.</source>
        <translation>Sperren oder das Ende des Ablaufs abwarten, dann das Projekt öffnen.</translation>
    </message>
    <message>
        <source>A project cannot be opened while the actuator is armed or a procedure is running: a slow disk would delay Esc.</source>
        <translation>Bei freigegebenem Aktor oder laufendem Ablauf lässt sich kein Projekt öffnen: Ein langsamer Datenträger würde Esc verzögern.</translation>
    </message>
    <message>
        <source>Save it with a new name to keep it.</source>
        <translation>Zum Behalten unter neuem Namen speichern.</translation>
    </message>
    <message>
        <source>This is a copy of %1, without a name.</source>
        <translation>Dies ist eine Kopie von %1, ohne Namen.</translation>
    </message>
    <message>
        <source>The saved file is unchanged.</source>
        <translation>Die gespeicherte Datei ist unverändert.</translation>
    </message>
    <message>
        <source>The project&apos;s autosave could not be read; it was moved to %1.</source>
        <translation>Die automatische Sicherung des Projekts war nicht lesbar; sie liegt unter %1.</translation>
    </message>
    <message>
        <source>%1 opened with unsaved changes.</source>
        <translation>%1 mit ungespeicherten Änderungen geöffnet.</translation>
    </message>
    <message>
        <source>No recent projects</source>
        <translation>Keine zuletzt geöffneten Projekte</translation>
    </message>
    <message>
        <source>Unsaved work of %1 was recovered. Save it to keep it.</source>
        <translation>Ungespeicherte Arbeit an %1 wurde wiederhergestellt. Zum Behalten speichern.</translation>
    </message>
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
        <source>Save project as</source>
        <translation>Projekt speichern unter</translation>
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
        <source>Waiting for the trigger; click to cancel (Ctrl+R)</source>
        <translation>Wartet auf den Trigger; Klick bricht ab (Strg+R)</translation>
    </message>
    <message>
        <source>Waiting for the trigger</source>
        <translation>Wartet auf den Trigger</translation>
    </message>
    <message>
        <source>Disk too slow: samples are lost.</source>
        <translation>Datenträger zu langsam: Messwerte gehen verloren.</translation>
    </message>
    <message>
        <source>Record the measured signals to a file (Ctrl+R)</source>
        <translation>Messsignale in eine Datei aufzeichnen (Strg+R)</translation>
    </message>
    <message>
        <source>Recording to a file; click to stop (Ctrl+R)</source>
        <translation>Zeichnet in eine Datei auf; Klick beendet (Strg+R)</translation>
    </message>
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
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordPanel</name>
    <message>
        <source>Live rate: as the plots; limited by device and link</source>
        <translation>Live-Rate: wie die Diagramme; begrenzt durch Gerät und Verbindung</translation>
    </message>
    <message>
        <source>live rate</source>
        <translation>Live-Rate</translation>
    </message>
    <message>
        <source>Without file extension; empty: name mask %1 (File &gt; Preferences)</source>
        <translation>Ohne Dateiendung; leer: Namensmaske %1 (Datei &gt; Einstellungen)</translation>
    </message>
    <message>
        <source>Value of {name} in the name mask %1 (File &gt; Preferences)</source>
        <translation>Wert von {name} in der Namensmaske %1 (Datei &gt; Einstellungen)</translation>
    </message>
    <message>
        <source>Record from the next trigger event on (Ctrl+R)</source>
        <translation>Ab dem nächsten Triggerereignis aufzeichnen (Strg+R)</translation>
    </message>
    <message>
        <source>Cancel without recording (Ctrl+R)</source>
        <translation>Ohne Aufzeichnung abbrechen (Strg+R)</translation>
    </message>
    <message>
        <source>Cancel the wait</source>
        <translation>Warten abbrechen</translation>
    </message>
    <message>
        <source>No samples of the trigger signal.</source>
        <translation>Keine Messwerte des Triggersignals.</translation>
    </message>
    <message>
        <source>Trigger event of the recording</source>
        <translation>Triggerereignis der Aufzeichnung</translation>
    </message>
    <message>
        <source>Post-trigger</source>
        <translation>Nachtrigger</translation>
    </message>
    <message>
        <source>Pre-trigger</source>
        <translation>Vortrigger</translation>
    </message>
    <message>
        <source>The recording stops this long after the event; 0: manually</source>
        <translation>Die Aufzeichnung endet so lange nach dem Ereignis; 0: manuell</translation>
    </message>
    <message>
        <source>Post-trigger time</source>
        <translation>Nachtriggerzeit</translation>
    </message>
    <message>
        <source>At the trigger: Ctrl+R waits for the Monitor&apos;s trigger event (T in the plots shows the trigger)</source>
        <translation>Beim Trigger: Strg+R wartet auf das Triggerereignis des Monitors (T in den Diagrammen zeigt den Trigger)</translation>
    </message>
    <message>
        <source>manually</source>
        <translation>manuell</translation>
    </message>
    <message>
        <source>Time before the start that is included in the recording; 0: none</source>
        <translation>Zeit vor dem Beginn, die mit aufgezeichnet wird; 0: keine</translation>
    </message>
    <message>
        <source>Pre-trigger time</source>
        <translation>Vortriggerzeit</translation>
    </message>
    <message>
        <source>Use another disk or a lower sample rate.</source>
        <translation>Anderen Datenträger oder kleinere Abtastrate verwenden.</translation>
    </message>
    <message>
        <source>Disk too slow: samples are lost.</source>
        <translation>Datenträger zu langsam: Messwerte gehen verloren.</translation>
    </message>
    <message>
        <source>%1 of them because of a slow disk.</source>
        <translation>%1 davon wegen langsamen Datenträgers.</translation>
    </message>
    <message>
        <source>Lost: %1; positions in the .meta.json file.</source>
        <translation>Verloren: %1; Stellen in der .meta.json-Datei.</translation>
    </message>
    <message>
        <source>Data file with units; settings and markers are in the .meta.json file beside it.</source>
        <translation>Datendatei mit Einheiten; Einstellungen und Marken stehen in der .meta.json daneben.</translation>
    </message>
    <message>
        <source>Record the measured signals to a file (Ctrl+R)</source>
        <translation>Messsignale in eine Datei aufzeichnen (Strg+R)</translation>
    </message>
    <message>
        <source>Stop and complete the file (Ctrl+R)</source>
        <translation>Beenden und Datei abschließen (Strg+R)</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>Add a marker at this time (Enter in the note)</source>
        <translation>Marke zu diesem Zeitpunkt setzen (Eingabetaste in der Notiz)</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>Marke setzen</translation>
    </message>
    <message>
        <source>Text of the marker (Enter adds it)</source>
        <translation>Text der Marke (Eingabetaste setzt sie)</translation>
    </message>
    <message>
        <source>Lost on the link or by a slow disk; marked in the file</source>
        <translation>Auf der Verbindung oder durch langsamen Datenträger verloren; in der Datei markiert</translation>
    </message>
    <message>
        <source>Samples lost</source>
        <translation>Verlorene Messwerte</translation>
    </message>
    <message>
        <source>Samples written</source>
        <translation>Geschriebene Messwerte</translation>
    </message>
    <message>
        <source>Device time from the first sample to the last</source>
        <translation>Gerätezeit vom ersten bis zum letzten Messwert</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Abtastrate</translation>
    </message>
    <message>
        <source>Created if it does not exist</source>
        <translation>Wird bei Bedarf angelegt</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Ordner der Aufzeichnungen</translation>
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
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>On the disk</source>
        <translation>Auf der Festplatte</translation>
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
        <source>Start recording</source>
        <translation>Aufzeichnung starten</translation>
    </message>
    <message>
        <source>%1 (gaps: %2, %3 s)</source>
        <translation>%1 (Lücken: %2, %3 s)</translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) in %1</source>
        <translation>
            <numerusform>%Ln Zeile in %1</numerusform>
            <numerusform>%Ln Zeilen in %1</numerusform>
        </translation>
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
        <source>Start</source>
        <translation>Beginn</translation>
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
        <source>Wait for the trigger</source>
        <translation>Auf den Trigger warten</translation>
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
        <source>Maximum of device and link: %1 Hz. Choose a lower rate, or plot fewer signals.</source>
        <translation>Maximum von Gerät und Verbindung: %1 Hz. Kleinere Rate wählen oder weniger Signale darstellen.</translation>
    </message>
    <message>
        <source>The plotted signals cannot be recorded at %1 Hz.</source>
        <translation>Die dargestellten Signale lassen sich nicht mit %1 Hz aufzeichnen.</translation>
    </message>
    <message>
        <source>%1. The data recorded until then are in %2.</source>
        <translation>%1. Die bis dahin aufgezeichneten Daten sind in %2.</translation>
    </message>
    <message>
        <source>Choose another name; existing recordings are not overwritten.</source>
        <translation>Anderen Namen wählen; vorhandene Aufzeichnungen werden nicht überschrieben.</translation>
    </message>
    <message>
        <source>Nothing to record.</source>
        <translation>Nichts aufzuzeichnen.</translation>
    </message>
    <message>
        <source>Connect a device first.</source>
        <translation>Verbinden Sie zuerst ein Gerät.</translation>
    </message>
    <message>
        <source>%1 exists already.</source>
        <translation>%1 gibt es bereits.</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingFields</name>
    <message>
        <source>Nothing is deleted from %1: %2 has a date in the future. Check the clock.</source>
        <translation>Aus %1 wird nichts gelöscht: %2 hat ein Datum in der Zukunft. Uhr prüfen.</translation>
    </message>
    <message numerus="yes">
        <source>OK moves %n recording(s) to the trash now (%1), from %2.</source>
        <translation>
            <numerusform>OK verschiebt jetzt %n Aufzeichnung in den Papierkorb (%1), aus %2.</numerusform>
            <numerusform>OK verschiebt jetzt %n Aufzeichnungen in den Papierkorb (%1), aus %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>OK deletes nothing from %1 now.</source>
        <translation>OK löscht jetzt nichts aus %1.</translation>
    </message>
    <message>
        <source>Currently never.</source>
        <translation>Derzeit nie.</translation>
    </message>
    <message>
        <source>Delete old recordings</source>
        <translation>Alte Aufzeichnungen löschen</translation>
    </message>
    <message>
        <source>Recordings to be deleted now</source>
        <translation>Jetzt zu löschende Aufzeichnungen</translation>
    </message>
    <message>
        <source>Disk space above which recordings are deleted</source>
        <translation>Speicherplatz, über dem Aufzeichnungen gelöscht werden</translation>
    </message>
    <message>
        <source>Delete recordings by disk space</source>
        <translation>Aufzeichnungen nach Speicherplatz löschen</translation>
    </message>
    <message>
        <source>Age at which recordings are deleted, in days</source>
        <translation>Alter in Tagen, ab dem Aufzeichnungen gelöscht werden</translation>
    </message>
    <message>
        <source>Delete recordings by age</source>
        <translation>Aufzeichnungen nach Alter löschen</translation>
    </message>
    <message>
        <source>a&amp;bove</source>
        <translation>ü&amp;ber</translation>
    </message>
    <message>
        <source>&amp;older than</source>
        <translation>ä&amp;lter als</translation>
    </message>
    <message>
        <source>The oldest recordings named by the program move to the trash. Recordings that are open, younger than a day or have tags, notes or results are kept</source>
        <translation>Die ältesten vom Programm benannten Aufzeichnungen kommen in den Papierkorb. Offene, weniger als einen Tag alte und solche mit Schlagwörtern, Notizen oder Ergebnissen bleiben</translation>
    </message>
    <message>
        <source>Names of unnamed recordings: {device}, {date} and {time} (UTC), {number}; {name} is set in the Record panel</source>
        <translation>Namen unbenannter Aufzeichnungen: {device}, {date} und {time} (UTC), {number}; {name} aus dem Bereich Aufnahme</translation>
    </message>
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
        <source>Example of a recording&apos;s name</source>
        <translation>Beispiel für den Namen einer Aufzeichnung</translation>
    </message>
    <message>
        <source>&amp;Names of recordings</source>
        <translation>&amp;Namen von Aufzeichnungen</translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
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
        <source>Checking recordings…</source>
        <translation>Prüft Aufzeichnungen …</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingPlace</name>
    <message>
        <source>Folder %1 of the last recording not found. Recordings are saved to %2.</source>
        <translation>Ordner %1 der letzten Aufzeichnung nicht gefunden. Aufzeichnungen werden in %2 gespeichert.</translation>
    </message>
    <message>
        <source>recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingTidying</name>
    <message>
        <source>nothing deleted: %1 has a date in the future, check the clock</source>
        <translation>nichts gelöscht: %1 hat ein Datum in der Zukunft, Uhr prüfen</translation>
    </message>
    <message>
        <source>above the disk limit in the preferences</source>
        <translation>über der Speichergrenze in den Einstellungen</translation>
    </message>
    <message>
        <source>older than the limit in the preferences</source>
        <translation>älter als die Grenze in den Einstellungen</translation>
    </message>
    <message>
        <source>not deleted: %1</source>
        <translation>nicht gelöscht: %1</translation>
    </message>
    <message>
        <source>recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>moved to the trash: %1 (%2)</source>
        <translation>in den Papierkorb verschoben: %1 (%2)</translation>
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
        <source>Show in Tune how this move would run with the proposed gains</source>
        <translation>In Auslegen zeigen, wie diese Bewegung mit den vorgeschlagenen Reglerparametern verliefe</translation>
    </message>
    <message>
        <source>What-if</source>
        <translation>Was-wäre-wenn</translation>
    </message>
    <message>
        <source>Import creates a recording; the table is not changed.</source>
        <translation>Importieren erzeugt eine Aufzeichnung; die Tabelle bleibt unverändert.</translation>
    </message>
    <message>
        <source>This table is from another program. Check below how it is read.</source>
        <translation>Diese Tabelle stammt von einem anderen Programm. Unten prüfen, wie sie gelesen wird.</translation>
    </message>
    <message>
        <source>Replay the recording as a live device (Ctrl+Return). Disconnects the device; not available while it is armed, recording or busy</source>
        <translation>Aufzeichnung wie ein Live-Gerät wiedergeben (Strg+Eingabe). Trennt das Gerät; nicht verfügbar, solange es freigegeben ist, aufzeichnet oder arbeitet</translation>
    </message>
    <message>
        <source>Show the whole recording in the panels (Enter). Disconnects the device; not available while it is armed, recording or busy</source>
        <translation>Ganze Aufzeichnung in den Bereichen zeigen (Eingabe). Trennt das Gerät; nicht verfügbar, solange es freigegeben ist, aufzeichnet oder arbeitet</translation>
    </message>
    <message>
        <source>Enter opens the selected recording; several are overlaid</source>
        <translation>Eingabe öffnet die gewählte Aufzeichnung; mehrere werden überlagert</translation>
    </message>
    <message>
        <source>The damaged file was saved as %1.</source>
        <translation>Die beschädigte Datei wurde als %1 gesichert.</translation>
    </message>
    <message>
        <source>Lost: %1 bytes, damaged or at the end.</source>
        <translation>Verloren: %1 Bytes, beschädigt oder am Ende.</translation>
    </message>
    <message>
        <source>All written data were recovered.</source>
        <translation>Alle geschriebenen Daten wurden wiederhergestellt.</translation>
    </message>
    <message>
        <source>No recordings in %1 yet. To make one: Record data (Ctrl+R).</source>
        <translation>Noch keine Aufzeichnungen in %1. Neue anlegen: „Daten aufzeichnen“ (Strg+R).</translation>
    </message>
    <message>
        <source>Saved in the .meta.json file</source>
        <translation>Gespeichert in der .meta.json-Datei</translation>
    </message>
    <message>
        <source>Search words, saved in the .meta.json file</source>
        <translation>Suchwörter, gespeichert in der .meta.json-Datei</translation>
    </message>
    <message>
        <source>Recover an interrupted recording</source>
        <translation>Unterbrochene Aufzeichnung wiederherstellen</translation>
    </message>
    <message>
        <source>Start time of the replay; Enter jumps there</source>
        <translation>Startzeit der Wiedergabe; Eingabe springt dorthin</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>Start bei</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergeben</translation>
    </message>
    <message>
        <source>Read the folder again (F5)</source>
        <translation>Ordner neu lesen (F5)</translation>
    </message>
    <message>
        <source>All words must occur (Ctrl+F)</source>
        <translation>Alle Wörter müssen vorkommen (Strg+F)</translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation>Aufzeichnungen suchen</translation>
    </message>
    <message>
        <source>Search name, device, date, signals, tags, notes</source>
        <translation>Name, Gerät, Datum, Signale, Schlagwörter, Notizen suchen</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
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
        <source>Notes on the recording</source>
        <translation>Notizen zur Aufzeichnung</translation>
    </message>
    <message>
        <source>Notes on this recording</source>
        <translation>Notizen zu dieser Aufzeichnung</translation>
    </message>
    <message>
        <source>An interrupted recording was recovered: %1 s in %2</source>
        <translation>Eine unterbrochene Aufzeichnung wurde wiederhergestellt: %1 s in %2</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
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
        <source>Select a recording to open or replay it.</source>
        <translation>Zum Öffnen oder Abspielen eine Aufzeichnung wählen.</translation>
    </message>
    <message>
        <source>Several are overlaid below; select one to open it.</source>
        <translation>Mehrere werden unten überlagert; zum Öffnen eine wählen.</translation>
    </message>
    <message>
        <source>Interrupted: recover it first.</source>
        <translation>Unterbrochen: zuerst wiederherstellen.</translation>
    </message>
    <message>
        <source>End the current recording first.</source>
        <translation>Zuerst die laufende Aufzeichnung beenden.</translation>
    </message>
    <message>
        <source>Disarm the device first.</source>
        <translation>Zuerst das Gerät sperren.</translation>
    </message>
    <message>
        <source>Wait for the end of the procedure.</source>
        <translation>Das Ende des Ablaufs abwarten.</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Pfad kopieren</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>The recording cannot be opened now.</source>
        <translation>Die Aufzeichnung lässt sich jetzt nicht öffnen.</translation>
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
        <source>Allowed: 1 to 32.</source>
        <translation>Erlaubt: 1 bis 32.</translation>
    </message>
    <message>
        <source>%1 plateaus entered.</source>
        <translation>%1 Plateaus eingegeben.</translation>
    </message>
    <message>
        <source>Enter currents in A, e.g. 1.6; 2; 2.4.</source>
        <translation>Ströme in A eingeben, z. B. 1,6; 2; 2,4.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid current.</source>
        <translation>„%1“ ist kein gültiger Strom.</translation>
    </message>
    <message>
        <source>Up to 32 currents in A, separated by spaces or semicolons</source>
        <translation>Bis zu 32 Ströme in A, durch Leerzeichen oder Semikolon getrennt</translation>
    </message>
    <message>
        <source>Generator signal added to the set-point</source>
        <translation>Generatorsignal, das zum Sollwert addiert wird</translation>
    </message>
    <message>
        <source>Time of each current</source>
        <translation>Dauer jedes Stroms</translation>
    </message>
    <message>
        <source>Plateau time</source>
        <translation>Plateauzeit</translation>
    </message>
    <message>
        <source>Afterwards a position is held and a current goes to zero</source>
        <translation>Danach wird eine Position gehalten, ein Strom geht auf null</translation>
    </message>
    <message>
        <source>Constant speed or current added to the shape</source>
        <translation>Konstante Geschwindigkeit oder konstanter Strom, zur Form addiert</translation>
    </message>
    <message>
        <source>Phase seed of the multisine; 0: low crest factor</source>
        <translation>Startwert der Multisinus-Phasen; 0: kleiner Scheitelfaktor</translation>
    </message>
    <message>
        <source>Steps of a staircase, lines of a multisine (max. 32)</source>
        <translation>Stufen einer Treppe, Linien eines Multisinus (max. 32)</translation>
    </message>
    <message>
        <source>Number of steps</source>
        <translation>Anzahl der Stufen</translation>
    </message>
    <message>
        <source>Time of each step</source>
        <translation>Dauer jeder Stufe</translation>
    </message>
    <message>
        <source>Step time</source>
        <translation>Stufenzeit</translation>
    </message>
    <message>
        <source>End frequency of chirp and multisine</source>
        <translation>Endfrequenz von Chirp und Multisinus</translation>
    </message>
    <message>
        <source>End frequency</source>
        <translation>Endfrequenz</translation>
    </message>
    <message>
        <source>Frequency of the sine; start frequency of chirp and multisine</source>
        <translation>Frequenz des Sinus; Startfrequenz von Chirp und Multisinus</translation>
    </message>
    <message>
        <source>Slope of the ramp; negative: backward</source>
        <translation>Steigung der Rampe; negativ: rückwärts</translation>
    </message>
    <message>
        <source>Height of one step (step, staircase), amplitude (sine, chirp), rms (multisine), end value (ramp; 0: no end)</source>
        <translation>Höhe einer Stufe (Sprung, Treppe), Amplitude (Sinus, Chirp), Effektivwert (Multisinus), Endwert (Rampe; 0: ohne Ende)</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
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
        <translation>Form der Führungsgröße</translation>
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
        <source>Currents (A)</source>
        <translation>Ströme (A)</translation>
    </message>
    <message>
        <source>Offset speed (added)</source>
        <translation>Zusätzliche Geschwindigkeit</translation>
    </message>
    <message>
        <source>Offset current (added)</source>
        <translation>Zusätzlicher Strom</translation>
    </message>
</context>
<context>
    <name>halbench::app::RelayForm</name>
    <message>
        <source>safe value</source>
        <translation>sicherer Wert</translation>
    </message>
    <message>
        <source>Cycles to measure, 40 to 400; the intervals shrink with the square root. Empty: 100</source>
        <translation>Gemessene Schwingungen, 40 bis 400; die Intervalle schrumpfen mit der Wurzel. Leer: 100</translation>
    </message>
    <message>
        <source>Saturation current of the controller. Empty: maximum safe value</source>
        <translation>Sättigungsstrom des Reglers. Leer: größter sicherer Wert</translation>
    </message>
    <message>
        <source>Steady speed of the oscillation, at least 3 rad/s in either direction, so that friction acts as a constant offset. Empty: lowest safe value</source>
        <translation>Stetige Drehzahl der Schwingung, mindestens 3 rad/s in einer der Richtungen; die Reibung wirkt dann als konstanter Versatz. Leer: kleinster sicherer Wert</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Schwingungen</translation>
    </message>
    <message>
        <source>Relay amplitude</source>
        <translation>Relaisamplitude</translation>
    </message>
    <message>
        <source>&amp;Base speed</source>
        <translation>&amp;Grunddrehzahl</translation>
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
        <source>Experiment cancelled. Nothing was changed.</source>
        <translation>Versuch abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Oscillation as recorded</source>
        <translation>Schwingung, wie aufgezeichnet</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>Zurück zu den Einstellungen; dieses Ergebnis bleibt bis zum nächsten Lauf</translation>
    </message>
    <message>
        <source>Save a file for tune --relay</source>
        <translation>Datei für tune --relay speichern</translation>
    </message>
    <message>
        <source>Propose Ziegler-Nichols gains with their assessment; nothing is applied</source>
        <translation>Reglerparameter nach Ziegler-Nichols mit Beurteilung vorschlagen; nichts wird übernommen</translation>
    </message>
    <message>
        <source>The rotor turns and oscillates (Ctrl+Return); Esc stops it</source>
        <translation>Der Rotor dreht sich und schwingt (Strg+Eingabe); Esc stoppt ihn</translation>
    </message>
    <message>
        <source>The rotor turns steadily and oscillates. STOP (Esc) and Cancel end the run. Gains, limits, mode, windows and generator are restored.</source>
        <translation>Der Rotor dreht sich stetig und schwingt. STOPP (Esc) und Abbrechen beenden den Lauf. Reglerparameter, Grenzwerte, Betriebsart, Fenster und Generator werden wiederhergestellt.</translation>
    </message>
    <message>
        <source>Measures the ultimate gain with its 95 % interval: the loop oscillates around a steady motion under saturating proportional control. Calibrate the sensors first.</source>
        <translation>Misst die kritische Verstärkung mit 95-%-Intervall: Der Kreis schwingt mit begrenztem P-Regler um eine stetige Bewegung. Zuerst die Sensoren kalibrieren.</translation>
    </message>
    <message>
        <source>Oscillate</source>
        <translation>Schwingen</translation>
    </message>
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
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Start experiment</source>
        <translation>Versuch starten</translation>
    </message>
    <message>
        <source>Use in Tune</source>
        <translation>In Auslegung verwenden</translation>
    </message>
    <message>
        <source>Save result…</source>
        <translation>Ergebnis speichern…</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
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
</context>
<context>
    <name>halbench::app::RelayWords</name>
    <message>
        <source>Speed range: %1 to %2 rad/s.</source>
        <translation>Drehzahlbereich: %1 bis %2 rad/s.</translation>
    </message>
    <message>
        <source>%1 cycles of %2° with %3 A; frequency scatter %4 %.</source>
        <translation>%1 Schwingungen von %2° mit %3 A; Streuung der Frequenz %4 %.</translation>
    </message>
    <message>
        <source>at %1 rad/s; extrapolated to −180°</source>
        <translation>bei %1 rad/s; auf −180° extrapoliert</translation>
    </message>
    <message>
        <source>phase at the oscillation</source>
        <translation>Phase bei der Schwingung</translation>
    </message>
    <message>
        <source>Device stops at %1 rad/s at the latest. Gains and limits are replaced during the experiment and always restored.</source>
        <translation>Das Gerät stoppt spätestens bei %1 rad/s. Reglerparameter und Grenzwerte werden für den Versuch ersetzt und immer wiederhergestellt.</translation>
    </message>
    <message>
        <source>Maximum current %1 A, maximum coil temperature %2 °C.</source>
        <translation>Größter Strom %1 A, höchste Spulentemperatur %2 °C.</translation>
    </message>
    <message>
        <source>Oscillation of about %1° every %2 s, speed %3 to %4 rad/s. The speed keeps its sign; the run stops outside the expected range.</source>
        <translation>Schwingung von etwa %1° alle %2 s, Drehzahl %3 bis %4 rad/s. Die Drehzahl behält ihr Vorzeichen; außerhalb des erwarteten Bereichs endet der Lauf.</translation>
    </message>
    <message>
        <source>No identified motor to compare with. Identify the motor.</source>
        <translation>Kein identifizierter Motor zum Vergleich. Motor identifizieren.</translation>
    </message>
    <message>
        <source>The identified motor disagrees: the intervals do not overlap.</source>
        <translation>Der identifizierte Motor stimmt nicht überein: Die Intervalle überlappen sich nicht.</translation>
    </message>
    <message>
        <source>The identified motor agrees: the intervals overlap.</source>
        <translation>Der identifizierte Motor stimmt überein: Die Intervalle überlappen sich.</translation>
    </message>
    <message>
        <source>See the findings above for cause and remedy</source>
        <translation>Ursache und Abhilfe siehe Befunde oben</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>verworfen</translation>
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
        <source>ultimate gain</source>
        <translation>kritische Verstärkung</translation>
    </message>
    <message>
        <source>ultimate period</source>
        <translation>kritische Periode</translation>
    </message>
</context>
<context>
    <name>halbench::app::StandstillRippleWords</name>
    <message>
        <source>current ripple at standstill about %1 A, more than angle noise (%2) explains: possible hunting; reduce K_D or K_P</source>
        <translation>Stromwelligkeit im Stillstand etwa %1 A, mehr als durch Winkelrauschen (%2): mögliches Pendeln; K_D oder K_P verringern</translation>
    </message>
    <message>
        <source>current ripple at standstill about %1 A: noise of the measured angle (%2) multiplied by these gains</source>
        <translation>Stromwelligkeit im Stillstand etwa %1 A: Rauschen des gemessenen Winkels (%2) mal Reglerparameter</translation>
    </message>
</context>
<context>
    <name>halbench::app::ResultHistoryView</name>
    <message>
        <source>Identification files (.json) of the folder, oldest first, with 95 % intervals; in brackets the drift since the first result of the same device</source>
        <translation>Identifikationsdateien (.json) des Ordners, älteste zuerst, mit 95-%-Intervallen; in Klammern die Drift seit dem ersten Ergebnis desselben Geräts</translation>
    </message>
    <message>
        <source>Drift since the first result of this device: within the intervals</source>
        <translation>Drift seit dem ersten Ergebnis dieses Geräts: innerhalb der Intervalle</translation>
    </message>
    <message>
        <source>Drift since the first result of this device: outside both intervals</source>
        <translation>Drift seit dem ersten Ergebnis dieses Geräts: außerhalb beider Intervalle</translation>
    </message>
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
        <source>simulated time</source>
        <translation>simulierte Zeit</translation>
    </message>
    <message>
        <source>Identified values over time</source>
        <translation>Identifizierte Werte über der Zeit</translation>
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
        <source>Old values written.</source>
        <translation>Alte Werte geschrieben.</translation>
    </message>
    <message>
        <source>Values changed during the connection loss: %1.</source>
        <translation>Während des Verbindungsverlusts geänderte Werte: %1.</translation>
    </message>
    <message>
        <source>The changed values were edited in the meantime.</source>
        <translation>Die geänderten Werte wurden inzwischen bearbeitet.</translation>
    </message>
    <message>
        <source>Its values are unchanged.</source>
        <translation>Seine Werte sind unverändert.</translation>
    </message>
    <message>
        <source>The recording continues with a gap.</source>
        <translation>Die Aufzeichnung läuft mit einer Lücke weiter.</translation>
    </message>
    <message>
        <source>The device&apos;s watchdog stops the motion.</source>
        <translation>Der Watchdog des Geräts stoppt die Bewegung.</translation>
    </message>
    <message>
        <source>Device values kept.</source>
        <translation>Gerätewerte behalten.</translation>
    </message>
    <message>
        <source>The device may have restarted. Nothing was written.</source>
        <translation>Das Gerät wurde vielleicht neu gestartet. Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Reconnected after %1 s, disarmed. Changed values: %2.</source>
        <translation>Nach %1 s wieder verbunden, gesperrt. Geänderte Werte: %2.</translation>
    </message>
    <message>
        <source>Reconnected after %1 s, disarmed.</source>
        <translation>Nach %1 s wieder verbunden, gesperrt.</translation>
    </message>
    <message>
        <source>Reconnecting; last attempt: %1.</source>
        <translation>Verbindung wird wiederhergestellt; letzter Versuch: %1.</translation>
    </message>
    <message>
        <source>Reconnecting.</source>
        <translation>Verbindung wird wiederhergestellt.</translation>
    </message>
    <message>
        <source>Keep the values that are on the device now</source>
        <translation>Werte behalten, die jetzt im Gerät sind</translation>
    </message>
    <message>
        <source>Keep device values</source>
        <translation>Gerätewerte behalten</translation>
    </message>
    <message>
        <source>Write the values from before the loss and read them back</source>
        <translation>Werte von vor dem Verlust schreiben und zurücklesen</translation>
    </message>
    <message>
        <source>Write old values</source>
        <translation>Alte Werte schreiben</translation>
    </message>
    <message>
        <source>Left: before the connection was lost; right: now</source>
        <translation>Links: vor dem Verbindungsverlust; rechts: jetzt</translation>
    </message>
    <message>
        <source>Changed values</source>
        <translation>Geänderte Werte</translation>
    </message>
    <message>
        <source>Connection lost: %1.</source>
        <translation>Verbindung verloren: %1.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Disconnect ends the search.</source>
        <translation>„Trennen“ beendet die Suche.</translation>
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
        <translation>Grenze bei Verstärkungsfaktor</translation>
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
        <source>Compare it with a copy: samples may be missing or changed.</source>
        <translation>Mit einer Kopie vergleichen: Messwerte können fehlen oder verändert sein.</translation>
    </message>
    <message>
        <source>No common data in this range. Choose another signal, alignment or range.</source>
        <translation>Keine gemeinsamen Daten in diesem Bereich. Anderes Signal, andere Ausrichtung oder anderen Bereich wählen.</translation>
    </message>
    <message>
        <source>Select recordings in the list to overlay their curves.</source>
        <translation>Aufzeichnungen in der Liste wählen, um ihre Kurven zu überlagern.</translation>
    </message>
    <message>
        <source>Maximum %1 recordings in an overlay</source>
        <translation>Höchstens %1 Aufzeichnungen in einer Überlagerung</translation>
    </message>
    <message>
        <source>%1 s around the cursor</source>
        <translation>%1 s um den Cursor</translation>
    </message>
    <message>
        <source>Whole recording or a range around the cursor</source>
        <translation>Ganze Aufzeichnung oder ein Bereich um den Cursor</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Alignment of the recordings</source>
        <translation>Ausrichtung der Aufzeichnungen</translation>
    </message>
    <message>
        <source>Position of the cursor line and of the values beside it</source>
        <translation>Position der Cursorlinie und der Werte daneben</translation>
    </message>
    <message>
        <source>Time zero: first sample, trigger, or a common marker</source>
        <translation>Zeitnullpunkt: erster Messwert, Trigger oder gemeinsame Marke</translation>
    </message>
    <message>
        <source>Signals common to all selected recordings</source>
        <translation>Signale, die alle gewählten Aufzeichnungen haben</translation>
    </message>
    <message>
        <source>Values of each recording at the cursor</source>
        <translation>Werte jeder Aufzeichnung am Cursor</translation>
    </message>
    <message>
        <source>Overlay of the selected recordings</source>
        <translation>Überlagerung der gewählten Aufzeichnungen</translation>
    </message>
    <message>
        <source>Values at the cursor</source>
        <translation>Werte am Cursor</translation>
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
        <source>Time of the cursor</source>
        <translation>Zeit des Cursors</translation>
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
        <source>all</source>
        <translation>alles</translation>
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
        <source>time</source>
        <translation>Zeit</translation>
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
        <source>Tick to plot a signal (Enter or Space), or drag it onto a plot</source>
        <translation>Ankreuzen stellt ein Signal dar (Eingabe- oder Leertaste), oder auf ein Diagramm ziehen</translation>
    </message>
    <message>
        <source>Signals of the device</source>
        <translation>Signale des Geräts</translation>
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
    <message>
        <source>Plot, or remove from the plots</source>
        <translation>Darstellen oder aus den Diagrammen nehmen</translation>
    </message>
    <message>
        <source>Copy the name for expressions and files</source>
        <translation>Namen für Ausdrücke und Dateien kopieren</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrogramFigure</name>
    <message>
        <source>Bin width %1 Hz, resolution %2 Hz, segments of %3 s</source>
        <translation>Linienabstand %1 Hz, Auflösung %2 Hz, Abschnitte von %3 s</translation>
    </message>
    <message>
        <source>Spectrogram of %1</source>
        <translation>Spektrogramm von %1</translation>
    </message>
    <message>
        <source>one every %1 s</source>
        <translation>einer alle %1 s</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrogramRange</name>
    <message>
        <source>The minimum of the colour scale must be below its maximum. Automatic scale used.</source>
        <translation>Das Minimum der Farbskala muss unter ihrem Maximum liegen. Automatische Skala verwendet.</translation>
    </message>
    <message>
        <source>The lowest frequency must be below the highest. All are shown.</source>
        <translation>Die niedrigste Frequenz muss unter der höchsten liegen. Alle werden gezeigt.</translation>
    </message>
    <message>
        <source>Value of the brightest colour; empty: automatic</source>
        <translation>Wert der hellsten Farbe; leer: automatisch</translation>
    </message>
    <message>
        <source>Colour scale max</source>
        <translation>Farbskala max</translation>
    </message>
    <message>
        <source>Value of the darkest colour; empty: automatic</source>
        <translation>Wert der dunkelsten Farbe; leer: automatisch</translation>
    </message>
    <message>
        <source>Colour scale min</source>
        <translation>Farbskala min</translation>
    </message>
    <message>
        <source>Highest frequency shown; empty: all</source>
        <translation>Höchste gezeigte Frequenz; leer: alle</translation>
    </message>
    <message>
        <source>Max. [Hz]</source>
        <translation>Max. [Hz]</translation>
    </message>
    <message>
        <source>Lowest frequency shown; empty: all</source>
        <translation>Niedrigste gezeigte Frequenz; leer: alle</translation>
    </message>
    <message>
        <source>Min. [Hz]</source>
        <translation>Min. [Hz]</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrumFigure</name>
    <message>
        <source>%1 (equal to %2 independent ones)</source>
        <translation>%1 (entspricht %2 unabhängigen)</translation>
    </message>
    <message>
        <source>no segment spans the %1 gaps and %2 missing values</source>
        <translation>kein Abschnitt überspannt die %1 Lücken und %2 fehlenden Werte</translation>
    </message>
    <message>
        <source>Bin width %1 Hz, resolution %2 Hz, segments of %3 s</source>
        <translation>Linienabstand %1 Hz, Auflösung %2 Hz, Abschnitte von %3 s</translation>
    </message>
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
        <source>95 % interval of noise: %1 to %2 times the line</source>
        <translation>95-%-Bereich bei Rauschen: das %1- bis %2-Fache der Linie</translation>
    </message>
    <message>
        <source>rms of all lines %1 %2</source>
        <translation>Effektivwert aller Linien %1 %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln average(s)</source>
        <translation>
            <numerusform>%Ln Mittelung</numerusform>
            <numerusform>%Ln Mittelungen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrumPanel</name>
    <message>
        <source>Colour scale in dB relative to 1 of the unit</source>
        <translation>Farbskala in dB, bezogen auf 1 der Einheit</translation>
    </message>
    <message>
        <source>Arrow keys move from the highest value (Shift: ten steps); Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>Pfeiltasten bewegen vom höchsten Wert aus (Umschalt: zehn Schritte); Strg+C kopiert das Bild, Strg+E speichert es</translation>
    </message>
    <message>
        <source>Spectrogram: spectra of the segments over time, in colours</source>
        <translation>Spektrogramm: Spektren der Abschnitte über der Zeit, in Farben</translation>
    </message>
    <message>
        <source>Spectrogram</source>
        <translation>Spektrogramm</translation>
    </message>
    <message>
        <source>Local maxima outside the window&apos;s main lobe</source>
        <translation>Lokale Maxima außerhalb der Hauptkeule des Fensters</translation>
    </message>
    <message>
        <source>Overlap of neighbouring segments</source>
        <translation>Überlappung benachbarter Abschnitte</translation>
    </message>
    <message>
        <source>Longer segments give finer resolution, more segments less noise. 0: full length for amplitudes, at least eight segments for densities</source>
        <translation>Längere Abschnitte lösen feiner auf, mehr Abschnitte mindern Rauschen. 0: volle Länge für Amplituden, mindestens acht Abschnitte für Dichten</translation>
    </message>
    <message>
        <source>Length of the analysed data, up to now</source>
        <translation>Länge der analysierten Daten bis jetzt</translation>
    </message>
    <message>
        <source>Time span</source>
        <translation>Zeitspanne</translation>
    </message>
    <message>
        <source>Window function: Hann in general, flat top for exact amplitudes, Blackman-Harris for weak lines near strong ones</source>
        <translation>Fensterfunktion: Hann allgemein, Flat-Top für genaue Amplituden, Blackman-Harris für schwache Linien neben starken</translation>
    </message>
    <message>
        <source>Amplitude or rms for steady sines; densities for noise, independent of the segment length</source>
        <translation>Amplitude oder Effektivwert für stationäre Sinusse; Dichten für Rauschen, unabhängig von der Abschnittslänge</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Signal to analyse; a signal can also be dropped here</source>
        <translation>Zu analysierendes Signal; Signale lassen sich auch hierher ziehen</translation>
    </message>
    <message>
        <source>Summary of the spectrum</source>
        <translation>Zusammenfassung des Spektrums</translation>
    </message>
    <message>
        <source>Arrow keys move along the lines; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>Pfeiltasten gehen die Linien entlang; Strg+C kopiert das Bild, Strg+E speichert es</translation>
    </message>
    <message>
        <source>Freeze the spectrum; data acquisition continues</source>
        <translation>Spektrum einfrieren; die Datenerfassung läuft weiter</translation>
    </message>
    <message>
        <source>Live spectrum of a signal. Connect a device: choose one on the left, or try the simulated motor.</source>
        <translation>Live-Spektrum eines Signals. Gerät verbinden: links wählen oder den simulierten Motor ausprobieren.</translation>
    </message>
    <message>
        <source>No data to analyse</source>
        <translation>Keine Daten zu analysieren</translation>
    </message>
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
        <source>Signal</source>
        <translation>Signal</translation>
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
        <source>Segment</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Highest peaks</source>
        <translation>Höchste Spitzen</translation>
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
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>Save the lines as a table (CSV), in SI units</source>
        <translation>Die Linien als Tabelle (CSV) in SI-Einheiten speichern</translation>
    </message>
</context>
<context>
    <name>halbench::app::StopLatch</name>
    <message>
        <source>Wait a moment, check the actuator, then release.</source>
        <translation>Kurz warten, den Aktor prüfen, dann aufheben.</translation>
    </message>
    <message>
        <source>The stop cannot be released yet.</source>
        <translation>Der Stopp lässt sich noch nicht aufheben.</translation>
    </message>
</context>
<context>
    <name>halbench::app::TopBar</name>
    <message>
        <source>Release the latched stop; does not arm. Locked shortly after a stop (Space)</source>
        <translation>Verriegelten Stopp aufheben; gibt nicht frei. Kurz nach einem Stopp gesperrt (Leertaste)</translation>
    </message>
    <message>
        <source>device was disarmed</source>
        <translation>Gerät war gesperrt</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>connection lost, reconnecting</source>
        <translation>Verbindung verloren, wird gesucht</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Aufheben</translation>
    </message>
</context>
<context>
    <name>halbench::app::TriggerBar</name>
    <message>
        <source>The device has no hold-off: it re-arms after its capture is read.</source>
        <translation>Das Gerät hat keine Sperrzeit: Es stellt sich nach dem Auslesen neu scharf.</translation>
    </message>
    <message>
        <source>The device has no hysteresis: each crossing is an event.</source>
        <translation>Das Gerät hat keine Hysterese: Jedes Kreuzen ist ein Ereignis.</translation>
    </message>
    <message>
        <source>The device detects one direction only.</source>
        <translation>Das Gerät erkennt nur eine Richtung.</translation>
    </message>
    <message>
        <source>The device waits for its event and shows nothing without it.</source>
        <translation>Das Gerät wartet auf sein Ereignis und zeigt ohne es nichts.</translation>
    </message>
    <message>
        <source>Live: searches the plotted samples. %1</source>
        <translation>Live: durchsucht die dargestellten Messwerte. %1</translation>
    </message>
    <message>
        <source>Live: searches the plotted samples. Board: the device waits and captures up to 4 plotted signals at its loop rate, 4096 samples</source>
        <translation>Live: durchsucht die dargestellten Messwerte. Gerät: Das Gerät wartet und erfasst bis zu 4 dargestellte Signale im Regeltakt, 4096 Messwerte</translation>
    </message>
    <message>
        <source>Not available on the device: computed in the program.</source>
        <translation>Im Gerät nicht verfügbar: wird im Programm berechnet.</translation>
    </message>
    <message>
        <source>Event in</source>
        <translation>Ereignis in</translation>
    </message>
    <message>
        <source>Set the level to the middle of the signal range in view, the hysteresis to 5 % of it</source>
        <translation>Pegel auf die Mitte des sichtbaren Signalbereichs setzen, Hysterese auf 5 % davon</translation>
    </message>
    <message>
        <source>Set level to 50 %</source>
        <translation>Pegel auf 50 % setzen</translation>
    </message>
    <message>
        <source>Minimum time between two events</source>
        <translation>Mindestzeit zwischen zwei Ereignissen</translation>
    </message>
    <message>
        <source>Share of the window before the event</source>
        <translation>Anteil des Fensters vor dem Ereignis</translation>
    </message>
    <message>
        <source>Pre-trigger</source>
        <translation>Vortrigger</translation>
    </message>
    <message>
        <source>Time span of the triggered view</source>
        <translation>Zeitspanne der getriggerten Ansicht</translation>
    </message>
    <message>
        <source>Distance from the level that re-arms the trigger</source>
        <translation>Abstand vom Pegel, der den Trigger neu scharf stellt</translation>
    </message>
    <message>
        <source>Trigger level; the line in the plot can be dragged</source>
        <translation>Triggerpegel; die Linie im Diagramm lässt sich ziehen</translation>
    </message>
    <message>
        <source>Slope of the trigger edge</source>
        <translation>Richtung der Triggerflanke</translation>
    </message>
    <message>
        <source>Signal whose edge is the trigger event, or the set-point</source>
        <translation>Signal, dessen Flanke das Triggerereignis ist, oder der Sollwert</translation>
    </message>
    <message>
        <source>Auto: free-running without events; Normal: waits; Single: stops after one event</source>
        <translation>Auto: freilaufend ohne Ereignis; Normal: wartet; Einzel: hält nach einem Ereignis an</translation>
    </message>
    <message>
        <source>State of the trigger</source>
        <translation>Zustand des Triggers</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Betriebsart</translation>
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
        <source>Slope</source>
        <translation>Flanke</translation>
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
        <source>Hysteresis</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Hold-off</source>
        <translation>Sperrzeit</translation>
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
        <source>the reference starts</source>
        <translation>die Führungsgröße startet</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneForm</name>
    <message>
        <source>From the relay experiment; empty: from the model</source>
        <translation>Aus dem Relaisversuch; leer: aus dem Modell</translation>
    </message>
    <message>
        <source>Largest reference step without current saturation</source>
        <translation>Größter Führungssprung ohne Strombegrenzung</translation>
    </message>
    <message>
        <source>Step height</source>
        <translation>Sprunghöhe</translation>
    </message>
    <message>
        <source>Current allowed in a step of the height below; at most the device limit</source>
        <translation>Zulässiger Strom bei einem Sprung der Höhe unten; höchstens der Gerätegrenzwert</translation>
    </message>
    <message>
        <source>device limit</source>
        <translation>Gerätegrenzwert</translation>
    </message>
    <message>
        <source>Limit of the sensitivity peak: 1.4 robust, 2 fast. The Numbers page shows whether this limit is active</source>
        <translation>Grenze der Empfindlichkeitsspitze: 1,4 robust, 2 schnell. Die Seite „Zahlen“ zeigt, ob diese Grenze wirkt</translation>
    </message>
    <message>
        <source>Maximum Ms</source>
        <translation>Maximales Ms</translation>
    </message>
    <message>
        <source>Target of the design; empty: default of the method</source>
        <translation>Ziel des Entwurfs; leer: Vorgabe des Verfahrens</translation>
    </message>
    <message>
        <source>values below</source>
        <translation>Werte unten</translation>
    </message>
    <message>
        <source>Edited manually</source>
        <translation>Von Hand bearbeitet</translation>
    </message>
    <message>
        <source>gains active on the device</source>
        <translation>im Gerät aktive Reglerparameter</translation>
    </message>
    <message>
        <source>Device values</source>
        <translation>Gerätewerte</translation>
    </message>
    <message>
        <source>Design method, built-in preset or device values</source>
        <translation>Entwurfsverfahren, mitgelieferter Parametersatz oder Gerätewerte</translation>
    </message>
    <message>
        <source>Source of the gains</source>
        <translation>Herkunft der Reglerparameter</translation>
    </message>
    <message>
        <source>Gain so&amp;urce</source>
        <translation>Reglerparameter a&amp;us</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>Berichtigen Sie es, oder lassen Sie es leer</translation>
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
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
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
        <source>not settled after %1</source>
        <translation>nach %1 nicht eingeschwungen</translation>
    </message>
    <message>
        <source>Time until the angle stays within 10 % of the peak around its final value</source>
        <translation>Zeit, bis der Winkel innerhalb 10 % der Spitze um seinen Endwert bleibt</translation>
    </message>
    <message>
        <source>longer than the time shown</source>
        <translation>länger als die gezeigte Zeit</translation>
    </message>
    <message>
        <source>Settling after load</source>
        <translation>Ausregelzeit nach Last</translation>
    </message>
    <message>
        <source>Largest deviation of the linear loop after the load step</source>
        <translation>Größte Abweichung des linearen Kreises nach dem Lastsprung</translation>
    </message>
    <message>
        <source>Peak after a load step equal to %1 A</source>
        <translation>Spitze nach einem Lastsprung gleich %1 A</translation>
    </message>
    <message>
        <source>Verification after each step: %1 forth and back in %2. Device stops at %3 or %4.</source>
        <translation>Nachweis nach jedem Schritt: %1 hin und zurück in %2. Das Gerät stoppt bei %3 oder %4.</translation>
    </message>
    <message>
        <source>Verification: %1 in %2. Device stops at %3 or %4.</source>
        <translation>Nachweis: %1 in %2. Das Gerät stoppt bei %3 oder %4.</translation>
    </message>
    <message>
        <source>Smaller oscillations decay</source>
        <translation>Kleinere Schwingungen klingen ab</translation>
    </message>
    <message>
        <source>Growth threshold</source>
        <translation>Anwachsschwelle</translation>
    </message>
    <message>
        <source>Harmonic balance does not cover the micro-step assist or a motor without friction</source>
        <translation>Die harmonische Balance erfasst weder Mikroschritthilfe noch reibungsfreie Motoren</translation>
    </message>
    <message>
        <source>Sustained oscillation due to friction and current limit (harmonic balance)</source>
        <translation>Dauerschwingung durch Reibung und Stromgrenze (harmonische Balance)</translation>
    </message>
    <message>
        <source>From half the friction band. The rotor then jumps and may stick again (hunting)</source>
        <translation>Ab halbem Reibungsband. Der Rotor springt dann und haftet eventuell wieder (Pendeln)</translation>
    </message>
    <message>
        <source>Stick time before integral moves it</source>
        <translation>Haftzeit bis zur Wirkung des I-Anteils</translation>
    </message>
    <message>
        <source>Stability of the loop with one more sample of delay</source>
        <translation>Stabilität des Kreises mit einer Abtastung mehr Totzeit</translation>
    </message>
    <message>
        <source>One sample more delay</source>
        <translation>Eine Abtastung mehr Totzeit</translation>
    </message>
    <message>
        <source>Larger steps reach the current limit</source>
        <translation>Größere Sprünge erreichen die Stromgrenze</translation>
    </message>
    <message>
        <source>Largest step without saturation</source>
        <translation>Größter Sprung ohne Begrenzung</translation>
    </message>
    <message>
        <source>Current noise per radian of angle noise</source>
        <translation>Stromrauschen je Radiant Winkelrauschen</translation>
    </message>
    <message>
        <source>Maximum amplification of disturbances; usually at most 2</source>
        <translation>Größte Verstärkung von Störungen; üblich höchstens 2</translation>
    </message>
    <message>
        <source>Sensitivity peak Ms</source>
        <translation>Empfindlichkeitsspitze Ms</translation>
    </message>
    <message>
        <source>Active limit: it prevents a smaller error after a load step</source>
        <translation>Wirkende Grenze: Sie verhindert einen kleineren Fehler nach einem Lastsprung</translation>
    </message>
    <message>
        <source>%1: limit active</source>
        <translation>%1: Grenze wirkt</translation>
    </message>
    <message>
        <source>max. deviation from the prediction %1 at %2 s</source>
        <translation>größte Abweichung von der Vorhersage %1 bei %2 s</translation>
    </message>
    <message>
        <source>overshoot %1 % (%2 % above the limit)</source>
        <translation>Überschwingen %1 % (%2 % über der Grenze)</translation>
    </message>
    <message>
        <source>final error %1 (%2 above the limit)</source>
        <translation>Endfehler %1 (%2 über der Grenze)</translation>
    </message>
    <message>
        <source>final error %1 (limit %2)</source>
        <translation>Endfehler %1 (Grenze %2)</translation>
    </message>
    <message>
        <source>Possible standstill error due to friction</source>
        <translation>Möglicher Stillstandsfehler durch Reibung</translation>
    </message>
    <message>
        <source>Stability limit of the sampled loop</source>
        <translation>Stabilitätsgrenze des Abtastregelkreises</translation>
    </message>
    <message>
        <source>Smallest distance of the open loop from -1; usually at least 0.5</source>
        <translation>Kleinster Abstand des offenen Kreises von -1; üblich mindestens 0,5</translation>
    </message>
    <message>
        <source>Additional delay at the stability limit</source>
        <translation>Zusätzliche Totzeit an der Stabilitätsgrenze</translation>
    </message>
    <message>
        <source>Frequency at which the open-loop gain is 1</source>
        <translation>Frequenz, bei der der offene Kreis die Verstärkung 1 hat</translation>
    </message>
    <message>
        <source>Share of the motors within the model&apos;s uncertainty for which this loop is unstable</source>
        <translation>Anteil der Motoren innerhalb der Modellunsicherheit, für die dieser Kreis instabil ist</translation>
    </message>
    <message>
        <source>Share of unstable cases</source>
        <translation>Anteil instabiler Fälle</translation>
    </message>
    <message>
        <source>Phase margin at the gain crossover; usually at least 30°</source>
        <translation>Phasenreserve bei der Durchtrittsfrequenz; üblich mindestens 30°</translation>
    </message>
    <message>
        <source>Gain factor at the stability limit; usually at least 2</source>
        <translation>Verstärkungsfaktor an der Stabilitätsgrenze; üblich mindestens 2</translation>
    </message>
    <message>
        <source>Poles of the sampled loop, with the device&apos;s delay</source>
        <translation>Pole des Abtastregelkreises, mit der Totzeit des Geräts</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>unendlich</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>Geschlossener Kreis</translation>
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
        <source>Phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>Gain crossover</source>
        <translation>Durchtrittsfrequenz</translation>
    </message>
    <message>
        <source>Delay margin</source>
        <translation>Totzeitreserve</translation>
    </message>
    <message>
        <source>Modulus margin</source>
        <translation>Modulreserve</translation>
    </message>
    <message>
        <source>Largest K_P</source>
        <translation>Größtes K_P</translation>
    </message>
    <message>
        <source>Friction band at rest</source>
        <translation>Reibungsband in Ruhe</translation>
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
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Current in a step of %1</source>
        <translation>Strom bei einem Sprung von %1</translation>
    </message>
    <message>
        <source>Noise gain</source>
        <translation>Rauschverstärkung</translation>
    </message>
    <message>
        <source>stays stable</source>
        <translation>bleibt stabil</translation>
    </message>
    <message>
        <source>%1 at %2 Hz, to %3 %</source>
        <translation>%1 bei %2 Hz, auf %3 %</translation>
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
        <source>Limit cycle</source>
        <translation>Dauerschwingung</translation>
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
        <source>%1: rise time</source>
        <translation>%1: Anstiegszeit</translation>
    </message>
    <message>
        <source>%1: overshoot</source>
        <translation>%1: Überschwingen</translation>
    </message>
    <message>
        <source>%1: settling time (2 %)</source>
        <translation>%1: Einschwingzeit (2 %)</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>eingeschwungen</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneNumbers</name>
    <message>
        <source>Range over the uncertainty of the identified motor</source>
        <translation>Bereich über die Unsicherheit des identifizierten Motors</translation>
    </message>
    <message>
        <source>5-95 % band</source>
        <translation>5-95-%-Band</translation>
    </message>
    <message>
        <source>Before applying</source>
        <translation>Vor dem Übernehmen</translation>
    </message>
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
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Motor (SI, 95 %): %1</source>
        <translation>Motor (SI, 95 %): %1</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Nachweis</translation>
    </message>
    <message>
        <source>Measured move and prediction, after Apply and verify</source>
        <translation>Gemessene Bewegung und Vorhersage, nach „Übernehmen, prüfen“</translation>
    </message>
    <message>
        <source>What-if</source>
        <translation>Was-wäre-wenn</translation>
    </message>
    <message>
        <source>Replay of a recorded move with the proposed gains</source>
        <translation>Wiedergabe einer aufgezeichneten Bewegung mit den vorgeschlagenen Reglerparametern</translation>
    </message>
</context>
<context>
    <name>halbench::app::TunePages</name>
    <message>
        <source>Tuning is not available for this device</source>
        <translation>Für dieses Gerät ist keine Reglereinstellung verfügbar</translation>
    </message>
    <message numerus="yes">
        <source>%n control loop(s), no identification procedure. Edit the gains in Parameters and check them with a reference in Drive.</source>
        <translation>
            <numerusform>%n Regelkreis, kein Identifikationsablauf. Reglerparameter unter „Parameter“ bearbeiten und mit einer Führungsgröße unter „Antrieb“ prüfen.</numerusform>
            <numerusform>%n Regelkreise, kein Identifikationsablauf. Reglerparameter unter „Parameter“ bearbeiten und mit einer Führungsgröße unter „Antrieb“ prüfen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No axes to tune yet</source>
        <translation>Noch keine Achsen auszulegen</translation>
    </message>
    <message>
        <source>Gains are designed for identified axes and verified by a step of each axis before they are kept.</source>
        <translation>Verstärkungen werden für identifizierte Achsen ausgelegt und mit einem Sprung jeder Achse geprüft, bevor sie bleiben.</translation>
    </message>
    <message>
        <source>Identify the axes</source>
        <translation>Achsen identifizieren</translation>
    </message>
    <message>
        <source>No motor to tune</source>
        <translation>Kein Motor zum Auslegen</translation>
    </message>
    <message>
        <source>Gains are designed for an identified motor and verified by a move before they are kept.</source>
        <translation>Reglerparameter werden für einen identifizierten Motor entworfen und vor dem Behalten durch eine Bewegung nachgewiesen.</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>Den Motor identifizieren</translation>
    </message>
</context>
<context>
    <name>halbench::app::ApplyControls</name>
    <message>
        <source>Verification: %1</source>
        <translation>Nachweis: %1</translation>
    </message>
    <message>
        <source>Verification running</source>
        <translation>Nachweis läuft</translation>
    </message>
    <message>
        <source>Writing the gains</source>
        <translation>Die Reglerparameter werden geschrieben</translation>
    </message>
    <message>
        <source>These gains cannot be applied: %1. %2.</source>
        <translation>Diese Reglerparameter können nicht übernommen werden: %1; %2.</translation>
    </message>
    <message>
        <source>Relative to the start position of the rotor</source>
        <translation>Relativ zur Startposition des Rotors</translation>
    </message>
    <message>
        <source>Apply and verify</source>
        <translation>Übernehmen, prüfen</translation>
    </message>
    <message>
        <source>Write all gains together, then verify with a step; Esc stops it</source>
        <translation>Alle Reglerparameter zusammen schreiben, dann mit einem Sprung nachweisen; Esc stoppt</translation>
    </message>
    <message>
        <source>Apply gradually</source>
        <translation>Schrittweise übernehmen</translation>
    </message>
    <message>
        <source>Change K_P and K_P + K_D/T by at most half in each step. Each step is assessed before writing and verified by a move; on failure the previous gains are restored</source>
        <translation>K_P und K_P + K_D/T je Schritt höchstens um die Hälfte ändern. Jeder Schritt wird vor dem Schreiben beurteilt und durch eine Bewegung nachgewiesen; bei Misserfolg werden die vorigen Reglerparameter wiederhergestellt</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>New gains active until power-off (simulated: until disconnect). To keep them: Save to device, in the Parameters panel</source>
        <translation>Neue Reglerparameter gelten bis zum Ausschalten (simuliert: bis zum Trennen). Behalten: „Im Gerät speichern“ im Bereich Parameter</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Restore the previous gains</source>
        <translation>Vorige Reglerparameter wiederherstellen</translation>
    </message>
</context>
<context>
    <name>halbench::app::DesignComparison</name>
    <message>
        <source>not assessed: project entry cannot be read</source>
        <translation>nicht beurteilt: Projekteintrag nicht lesbar</translation>
    </message>
    <message>
        <source>not assessed yet</source>
        <translation>noch nicht beurteilt</translation>
    </message>
    <message>
        <source>not assessed: %1</source>
        <translation>nicht beurteilt: %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainDecision</name>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Not kept, previous gains restored: %1</source>
        <translation>Nicht behalten, vorige Reglerparameter wiederhergestellt: %1</translation>
    </message>
    <message>
        <source>Cancelled. Previous gains restored.</source>
        <translation>Abgebrochen. Vorige Reglerparameter wiederhergestellt.</translation>
    </message>
    <message>
        <source>Applied and verified: the move matched the prediction.</source>
        <translation>Übernommen und nachgewiesen: Die Bewegung entsprach der Vorhersage.</translation>
    </message>
    <message>
        <source>Keep the new gains, or restore the previous ones.</source>
        <translation>Neue Reglerparameter behalten oder die vorigen wiederherstellen.</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Auslegen</translation>
    </message>
    <message>
        <source>To keep them: Save to device, in the Parameters panel.</source>
        <translation>Behalten: „Im Gerät speichern“ im Bereich Parameter.</translation>
    </message>
    <message>
        <source>kept on %1</source>
        <translation>behalten auf %1</translation>
    </message>
    <message>
        <source>They are saved as design &apos;%1&apos; and can be applied again.</source>
        <translation>Sie sind als Entwurf „%1“ gespeichert und können erneut übernommen werden.</translation>
    </message>
    <message>
        <source>They are saved as design &apos;%1&apos;.</source>
        <translation>Sie sind als Entwurf „%1“ gespeichert.</translation>
    </message>
    <message>
        <source>New gains active until disconnect.</source>
        <translation>Neue Reglerparameter gelten bis zum Trennen.</translation>
    </message>
    <message>
        <source>New gains active until power-off.</source>
        <translation>Neue Reglerparameter gelten bis zum Ausschalten.</translation>
    </message>
    <message>
        <source>Previous gains restored.</source>
        <translation>Vorige Reglerparameter wiederhergestellt.</translation>
    </message>
    <message>
        <source>applied on %1</source>
        <translation>angewendet auf %1</translation>
    </message>
    <message>
        <source>Gains applied on %1 were neither kept nor restored.</source>
        <translation>Auf %1 übernommene Reglerparameter wurden weder behalten noch zurückgenommen.</translation>
    </message>
    <message>
        <source>%1 was disconnected with the kept gains.</source>
        <translation>%1 wurde mit den behaltenen Reglerparametern getrennt.</translation>
    </message>
    <message>
        <source>A simulated device is reset on disconnect.</source>
        <translation>Ein simuliertes Gerät wird beim Trennen zurückgesetzt.</translation>
    </message>
    <message>
        <source>They stay active until power-off.</source>
        <translation>Sie gelten bis zum Ausschalten.</translation>
    </message>
    <message>
        <source>They are saved as design &apos;%1&apos;. To use them: Use this design, then Apply and verify.</source>
        <translation>Sie sind als Entwurf „%1“ gespeichert. Verwenden: „Entwurf verwenden“, dann „Übernehmen, prüfen“.</translation>
    </message>
    <message>
        <source>Drive the motor</source>
        <translation>Motor bewegen</translation>
    </message>
    <message>
        <source>Open Parameters</source>
        <translation>Parameter öffnen</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainFiles</name>
    <message>
        <source>Open gains</source>
        <translation>Reglerparameter öffnen</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>Reglerparameter (*.json)</translation>
    </message>
    <message>
        <source>Gains of %1.</source>
        <translation>Reglerparameter aus %1.</translation>
    </message>
    <message>
        <source>Save gains</source>
        <translation>Reglerparameter speichern</translation>
    </message>
    <message>
        <source>Gains (*.json);;Control law as C code (*.c)</source>
        <translation>Reglerparameter (*.json);;Regelgesetz als C-Code (*.c)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>Save gains…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Save gains to a file</source>
        <translation>Reglerparameter in einer Datei speichern</translation>
    </message>
    <message>
        <source>Open gains…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Use the gains of a file as proposed gains; they are assessed before they can be applied</source>
        <translation>Reglerparameter einer Datei als Vorschlag verwenden; sie werden vor dem Übernehmen beurteilt</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainHistoryActions</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainSettings</name>
    <message>
        <source>Gains from the project: %1.</source>
        <translation>Reglerparameter aus dem Projekt: %1.</translation>
    </message>
    <message>
        <source>Choose a method to design new gains for the present motor model.</source>
        <translation>Verfahren wählen, um neue Reglerparameter für das jetzige Motormodell zu entwerfen.</translation>
    </message>
    <message>
        <source>Gain source: %1</source>
        <translation>Herkunft der Reglerparameter: %1</translation>
    </message>
    <message>
        <source>Edit the gains</source>
        <translation>Reglerparameter bearbeiten</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>%1 bearbeiten</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopShaping</name>
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
        <source>More gain would be unstable: limited.</source>
        <translation>Mehr Verstärkung wäre instabil: begrenzt.</translation>
    </message>
</context>
<context>
    <name>halbench::app::MeasuredOverlay</name>
    <message>
        <source>Open a measured response</source>
        <translation>Gemessenen Frequenzgang öffnen</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>Frequenzgang (*.json)</translation>
    </message>
    <message>
        <source>Measured response shown in the open loop, with the proposed gains.</source>
        <translation>Gemessener Frequenzgang im offenen Kreis gezeigt, mit den vorgeschlagenen Reglerparametern.</translation>
    </message>
    <message>
        <source>%1 of %2 frequencies are coherent; the others are hollow.</source>
        <translation>%1 von %2 Frequenzen sind kohärent; die anderen sind hohl.</translation>
    </message>
    <message>
        <source>Remove the response</source>
        <translation>Messung entfernen</translation>
    </message>
    <message>
        <source>Measured response…</source>
        <translation>Messung …</translation>
    </message>
    <message>
        <source>Show only predictions in the open loop</source>
        <translation>Im offenen Kreis nur Vorhersagen zeigen</translation>
    </message>
    <message>
        <source>Show the response measured with identify --frequency in the open loop, with the proposed gains (no motor model)</source>
        <translation>Mit identify --frequency gemessenen Frequenzgang im offenen Kreis zeigen, mit den vorgeschlagenen Reglerparametern (ohne Motormodell)</translation>
    </message>
</context>
<context>
    <name>halbench::app::PredictionPages</name>
    <message>
        <source>Open loop</source>
        <translation>Offener Kreis</translation>
    </message>
    <message>
        <source>Bode, Nyquist and Nichols plot, and sensitivity</source>
        <translation>Bode-, Nyquist- und Nichols-Diagramm sowie Empfindlichkeit</translation>
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
        <source>Small step</source>
        <translation>Kleiner Sprung</translation>
    </message>
    <message>
        <source>Step of the linear loop</source>
        <translation>Sprung des linearen Kreises</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Effect of a load step on the angle</source>
        <translation>Wirkung eines Lastsprungs auf den Winkel</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>All predicted figures, margins with intervals</source>
        <translation>Alle vorhergesagten Kennzahlen, Reserven mit Intervallen</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>Entwürfe</translation>
    </message>
    <message>
        <source>Saved designs, compared with the proposed gains</source>
        <translation>Gespeicherte Entwürfe, mit den vorgeschlagenen Reglerparametern verglichen</translation>
    </message>
    <message>
        <source>Predictions</source>
        <translation>Vorhersagen</translation>
    </message>
</context>
<context>
    <name>halbench::app::VerificationPage</name>
    <message>
        <source>No verification yet</source>
        <translation>Noch kein Nachweis</translation>
    </message>
    <message>
        <source>Within the predicted band (gains no longer active)</source>
        <translation>Im vorhergesagten Band (Reglerparameter nicht mehr aktiv)</translation>
    </message>
    <message>
        <source>Within the predicted band (applied gains, not those shown)</source>
        <translation>Im vorhergesagten Band (übernommene Reglerparameter, nicht die gezeigten)</translation>
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
        <source>Outside the predicted band (applied gains, not those shown)</source>
        <translation>Außerhalb des vorhergesagten Bands (übernommene Reglerparameter, nicht die gezeigten)</translation>
    </message>
</context>
<context>
    <name>halbench::app::WhatIfRecording</name>
    <message>
        <source>Open a recorded move</source>
        <translation>Aufgezeichnete Bewegung öffnen</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4)</source>
        <translation>Aufzeichnung (*.csv *.mf4)</translation>
    </message>
    <message>
        <source>Open the active gains of the recording</source>
        <translation>Bei der Aufzeichnung aktive Reglerparameter öffnen</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>Reglerparameter (*.json)</translation>
    </message>
    <message>
        <source>The recording is shown after a motor is identified.</source>
        <translation>Die Aufzeichnung wird gezeigt, sobald ein Motor identifiziert ist.</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Auslegen</translation>
    </message>
    <message>
        <source>What-if: %1</source>
        <translation>Was-wäre-wenn: %1</translation>
    </message>
    <message>
        <source>Choose the file with the gains that were active during the recording.</source>
        <translation>Datei mit den bei der Aufzeichnung aktiven Reglerparametern wählen.</translation>
    </message>
    <message>
        <source>Recorded gains…</source>
        <translation>Damalige Reglerparameter …</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuningFigures</name>
    <message>
        <source>%1 encirclements; unstable poles of L: %2</source>
        <translation>%1 Umläufe; instabile Pole von L: %2</translation>
    </message>
    <message>
        <source>settling time</source>
        <translation>Ausregelzeit</translation>
    </message>
    <message>
        <source>Load step equal to %1 A, linear model</source>
        <translation>Lastsprung gleich %1 A, lineares Modell</translation>
    </message>
    <message>
        <source>90 % band</source>
        <translation>90-%-Band</translation>
    </message>
    <message>
        <source>5-95 % band (motor uncertainty)</source>
        <translation>5-95-%-Band (Motorunsicherheit)</translation>
    </message>
    <message>
        <source>measured, low coherence</source>
        <translation>gemessen, geringe Kohärenz</translation>
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
        <translation>Nachweisbewegung</translation>
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
        <source>with the proposed gains</source>
        <translation>mit den vorgeschlagenen Reglerparametern</translation>
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
        <source>angle from the reference</source>
        <translation>Winkel gegen die Führungsgröße</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>other crossings</source>
        <translation>andere Durchtritte</translation>
    </message>
</context>
<context>
    <name>halbench::app::UnsavedBar</name>
    <message>
        <source>Continue; unsaved changes are lost</source>
        <translation>Fortfahren; ungespeicherte Änderungen gehen verloren</translation>
    </message>
    <message>
        <source>Save to another place, then continue</source>
        <translation>An anderer Stelle speichern, dann fortfahren</translation>
    </message>
    <message>
        <source>Try to save again, then continue</source>
        <translation>Erneut speichern, dann fortfahren</translation>
    </message>
    <message>
        <source>The project stays open because saving failed: %1</source>
        <translation>Das Projekt bleibt geöffnet, weil das Speichern fehlschlug: %1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>Projekt speichern unter …</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
</context>
<context>
    <name>halbench::app::WhatIfPage</name>
    <message>
        <source>The proposed gains equal the recorded gains: the recording shows their result.</source>
        <translation>Die vorgeschlagenen Reglerparameter sind die damaligen: Die Aufzeichnung zeigt ihr Ergebnis.</translation>
    </message>
    <message>
        <source>%1 % of the recorded motion are outside the band of the recorded gains.</source>
        <translation>%1 % der aufgezeichneten Bewegung liegen außerhalb des Bands der damaligen Reglerparameter.</translation>
    </message>
    <message>
        <source>%1: doubtful, see below</source>
        <translation>%1: zweifelhaft, siehe unten</translation>
    </message>
    <message>
        <source>%1: the identified model matches the recorded move</source>
        <translation>%1: Das identifizierte Modell passt zur aufgezeichneten Bewegung</translation>
    </message>
    <message>
        <source>%1: identify the motor first</source>
        <translation>%1: zuerst den Motor identifizieren</translation>
    </message>
    <message>
        <source>Assessing %1</source>
        <translation>%1 wird beurteilt</translation>
    </message>
    <message>
        <source>%1: no prediction for the proposed gains</source>
        <translation>%1: keine Vorhersage für die vorgeschlagenen Reglerparameter</translation>
    </message>
    <message>
        <source>Clear this page; the recording is kept</source>
        <translation>Diese Seite leeren; die Aufzeichnung bleibt</translation>
    </message>
    <message>
        <source>What-if: replay a recorded move with the proposed gains. Needs an identified motor that matches the recording.</source>
        <translation>Was-wäre-wenn: eine aufgezeichnete Bewegung mit den vorgeschlagenen Reglerparametern wiedergeben. Braucht einen identifizierten Motor, der zur Aufzeichnung passt.</translation>
    </message>
    <message>
        <source>No recording selected</source>
        <translation>Keine Aufzeichnung gewählt</translation>
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
</context>
<context>
    <name>halbench::app::WhatIfWords</name>
    <message>
        <source>With the proposed gains: overshoot %1 instead of %2, final error %3 instead of %4.</source>
        <translation>Mit den vorgeschlagenen Reglerparametern: Überschwingen %1 statt %2, Endfehler %3 statt %4.</translation>
    </message>
    <message>
        <source>No prediction for the proposed gains: %1</source>
        <translation>Keine Vorhersage für die vorgeschlagenen Reglerparameter: %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::WizardPanel</name>
    <message>
        <source>Connect a device, or wait until the running task ends.</source>
        <translation>Gerät verbinden, oder das Ende der laufenden Aufgabe abwarten.</translation>
    </message>
    <message>
        <source>Not started: no device connected, or the device is busy.</source>
        <translation>Nicht gestartet: kein Gerät verbunden, oder das Gerät ist beschäftigt.</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::XyPanel</name>
    <message>
        <source>rms residual of the ellipse %1 % of the amplitude</source>
        <translation>Effektives Residuum der Ellipse %1 % der Amplitude</translation>
    </message>
    <message>
        <source>Semi-axes %1 and %2 %3</source>
        <translation>Halbachsen %1 und %2 %3</translation>
    </message>
    <message>
        <source>Phase error from 90°</source>
        <translation>Phasenfehler gegen 90°</translation>
    </message>
    <message>
        <source>Amplitude ratio</source>
        <translation>Amplitudenverhältnis</translation>
    </message>
    <message>
        <source>Fit an ellipse to the points; needs several turns (Alt+E)</source>
        <translation>Ellipse an die Punkte anpassen; braucht mehrere Umläufe (Alt+E)</translation>
    </message>
    <message>
        <source>Length of the data shown, up to now</source>
        <translation>Länge der gezeigten Daten bis jetzt</translation>
    </message>
    <message>
        <source>Time span</source>
        <translation>Zeitspanne</translation>
    </message>
    <message>
        <source>Signal of the vertical axis; a signal can also be dropped here</source>
        <translation>Signal der senkrechten Achse; Signale lassen sich auch hierher ziehen</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Signal of the horizontal axis; a signal can also be dropped here</source>
        <translation>Signal der waagerechten Achse; Signale lassen sich auch hierher ziehen</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Summary of the ellipse</source>
        <translation>Zusammenfassung der Ellipse</translation>
    </message>
    <message>
        <source>Arrow keys move along the points; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>Pfeiltasten gehen die Punkte entlang; Strg+C kopiert das Bild, Strg+E speichert es</translation>
    </message>
    <message>
        <source>Two signals plotted against each other, initially the Hall sensors with their ellipse. Connect a device: choose one on the left, or try the simulated motor.</source>
        <translation>Zwei Signale gegeneinander, anfangs die Hall-Sensoren mit ihrer Ellipse. Gerät verbinden: links wählen oder den simulierten Motor ausprobieren.</translation>
    </message>
    <message>
        <source>No data to show</source>
        <translation>Keine Daten zu zeigen</translation>
    </message>
    <message>
        <source>Fitted ellipse</source>
        <translation>Angepasste Ellipse</translation>
    </message>
    <message>
        <source>Ellip&amp;se</source>
        <translation>Ellip&amp;se</translation>
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
        <source>Active pair: %1. N adds a pair, P selects the next, F2 names it; the others are faint</source>
        <translation>Aktives Paar: %1. N fügt ein Paar hinzu, P wählt das nächste, F2 benennt es; die anderen sind blass</translation>
    </message>
    <message>
        <source>Name of the active pair; named pairs are saved in the project (F2)</source>
        <translation>Name des aktiven Paars; benannte Paare werden im Projekt gespeichert (F2)</translation>
    </message>
    <message>
        <source>Active pair</source>
        <translation>Aktives Paar</translation>
    </message>
    <message>
        <source>Time of cursor %1: type it, drag the line, or press %1 and the arrow keys</source>
        <translation>Zeit von Cursor %1: eintippen, Linie ziehen, oder %1 und Pfeiltasten drücken</translation>
    </message>
    <message>
        <source>Time of cursor %1</source>
        <translation>Zeit von Cursor %1</translation>
    </message>
    <message>
        <source>Distance of the cursors</source>
        <translation>Abstand der Cursor</translation>
    </message>
    <message>
        <source>Δt %1 s    1/Δt %2 Hz</source>
        <translation>Δt %1 s    1/Δt %2 Hz</translation>
    </message>
    <message>
        <source>Cursor pair</source>
        <translation>Cursorpaar</translation>
    </message>
    <message>
        <source>Name of the cursor pair</source>
        <translation>Name des Cursorpaars</translation>
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
        <source>No data to show</source>
        <translation>Keine Daten zu zeigen</translation>
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
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Drag: %1</source>
        <translation>Ziehen: %1</translation>
    </message>
    <message>
        <source>Ctrl and the arrow keys move: %1.</source>
        <translation>Strg und Pfeiltasten bewegen: %1.</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::Figures</name>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
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
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Move to</source>
        <translation>Verschieben nach</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>Wert kopieren</translation>
    </message>
    <message>
        <source>Space hides or shows the curve, F2 renames it, R changes its axis, U its unit, Ctrl with an arrow key moves it to the next plot, Ctrl+Shift+Down to a new plot, Ctrl+Shift+Right to a new plot beside, Delete removes it.</source>
        <translation>Leertaste blendet die Kurve aus oder ein, F2 benennt sie um, R wechselt ihre Achse, U ihre Einheit, Strg mit Pfeiltaste verschiebt sie ins nächste Diagramm, Strg+Umschalt+Herunter in ein neues Diagramm, Strg+Umschalt+Rechts in ein neues daneben, Entf entfernt sie.</translation>
    </message>
    <message>
        <source>New plot on the right</source>
        <translation>Neues Diagramm rechts</translation>
    </message>
    <message>
        <source>Plot on the right</source>
        <translation>Diagramm rechts</translation>
    </message>
    <message>
        <source>Plot on the left</source>
        <translation>Diagramm links</translation>
    </message>
    <message>
        <source>New plot</source>
        <translation>Neues Diagramm</translation>
    </message>
    <message>
        <source>Plot below</source>
        <translation>Diagramm darunter</translation>
    </message>
    <message>
        <source>Plot above</source>
        <translation>Diagramm darüber</translation>
    </message>
    <message>
        <source>Use right axis</source>
        <translation>Rechte Achse verwenden</translation>
    </message>
    <message>
        <source>Use left axis</source>
        <translation>Linke Achse verwenden</translation>
    </message>
    <message>
        <source>Selected curve</source>
        <translation>Gewählte Kurve</translation>
    </message>
    <message>
        <source>Legend with live values</source>
        <translation>Legende mit laufenden Werten</translation>
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
        <source>Remove from the plot</source>
        <translation>Aus dem Diagramm entfernen</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LivePlot</name>
    <message>
        <source>Arrow keys move a cursor or scroll, plus and minus zoom the time (Ctrl: the values), Space pauses, F fits, Insert adds signals.</source>
        <translation>Pfeiltasten bewegen einen Cursor oder verschieben, Plus und Minus zoomen die Zeit (Strg: die Werte), Leertaste hält an, F passt ein, Einfg fügt Signale hinzu.</translation>
    </message>
    <message>
        <source>Plot of %1, right axis %2</source>
        <translation>Diagramm: %1, rechte Achse %2</translation>
    </message>
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
        <source>%1, column %2</source>
        <translation>%1, Spalte %2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LivePlotStack</name>
    <message>
        <source>Own time axis, %1 s</source>
        <translation>Eigene Zeitachse, %1 s</translation>
    </message>
    <message>
        <source>Recorded data, %1 s</source>
        <translation>Aufgezeichnete Daten, %1 s</translation>
    </message>
    <message>
        <source>Paused for %1 s</source>
        <translation>Seit %1 s angehalten</translation>
    </message>
    <message>
        <source>Equal widths and heights for all plots</source>
        <translation>Gleiche Breiten und Höhen für alle Diagramme</translation>
    </message>
    <message>
        <source>Reduce the column width</source>
        <translation>Spaltenbreite verkleinern</translation>
    </message>
    <message>
        <source>Increase the column width</source>
        <translation>Spaltenbreite vergrößern</translation>
    </message>
    <message>
        <source>Reduce the plot height</source>
        <translation>Diagrammhöhe verkleinern</translation>
    </message>
    <message>
        <source>Increase the plot height</source>
        <translation>Diagrammhöhe vergrößern</translation>
    </message>
    <message>
        <source>Fit the value axes of the focused plot to its data</source>
        <translation>Wertachsen des fokussierten Diagramms an die Daten anpassen</translation>
    </message>
    <message>
        <source>Zoom out the values of the focused plot</source>
        <translation>Werte des fokussierten Diagramms verkleinern</translation>
    </message>
    <message>
        <source>Zoom in the values of the focused plot</source>
        <translation>Werte des fokussierten Diagramms vergrößern</translation>
    </message>
    <message>
        <source>All markers with their notes</source>
        <translation>Alle Marken mit ihren Notizen</translation>
    </message>
    <message>
        <source>Remove the selected marker</source>
        <translation>Gewählte Marke entfernen</translation>
    </message>
    <message>
        <source>Select the previous marker and show it</source>
        <translation>Vorige Marke wählen und zeigen</translation>
    </message>
    <message>
        <source>Select the next marker and show it</source>
        <translation>Nächste Marke wählen und zeigen</translation>
    </message>
    <message>
        <source>Edit the note of the selected marker, of the marker at this time, or of a new one</source>
        <translation>Notiz der gewählten Marke, der Marke zu diesem Zeitpunkt oder einer neuen bearbeiten</translation>
    </message>
    <message>
        <source>Remove the plot with its curves</source>
        <translation>Diagramm mit seinen Kurven entfernen</translation>
    </message>
    <message>
        <source>Empty plot in a new column</source>
        <translation>Leeres Diagramm in einer neuen Spalte</translation>
    </message>
    <message>
        <source>New plot on the right</source>
        <translation>Neues Diagramm rechts</translation>
    </message>
    <message>
        <source>Move the plot to the column on the left, or to a new column</source>
        <translation>Diagramm in die Spalte links oder eine neue Spalte verschieben</translation>
    </message>
    <message>
        <source>Move the plot to the column on the right, or to a new column</source>
        <translation>Diagramm in die Spalte rechts oder eine neue Spalte verschieben</translation>
    </message>
    <message>
        <source>Use the common time axis in all plots</source>
        <translation>Gemeinsame Zeitachse in allen Diagrammen verwenden</translation>
    </message>
    <message>
        <source>Zoom and scroll this plot separately; again: with the others</source>
        <translation>Dieses Diagramm getrennt zoomen und verschieben; erneut: mit den anderen</translation>
    </message>
    <message>
        <source>Own time axis, paused in history (End: live)</source>
        <translation>Eigene Zeitachse, angehalten im Verlauf (Ende: live)</translation>
    </message>
    <message>
        <source>Pair %1 exists already. Name unchanged: %2</source>
        <translation>Paar %1 existiert bereits. Name unverändert: %2</translation>
    </message>
    <message>
        <source>A pair needs a name. Name unchanged: %1</source>
        <translation>Ein Paar braucht einen Namen. Name unverändert: %1</translation>
    </message>
    <message>
        <source>Move the active pair into view</source>
        <translation>Aktives Paar ins Bild bewegen</translation>
    </message>
    <message>
        <source>Show the time around the active pair</source>
        <translation>Zeit um das aktive Paar zeigen</translation>
    </message>
    <message>
        <source>Name of the active pair; saved in the project</source>
        <translation>Name des aktiven Paars; wird im Projekt gespeichert</translation>
    </message>
    <message>
        <source>Activate the previous pair</source>
        <translation>Voriges Paar aktivieren</translation>
    </message>
    <message>
        <source>Activate the next pair</source>
        <translation>Nächstes Paar aktivieren</translation>
    </message>
    <message>
        <source>Remove the active pair</source>
        <translation>Aktives Paar entfernen</translation>
    </message>
    <message>
        <source>Add two cursors; the other pairs stay, faint</source>
        <translation>Zwei Cursor hinzufügen; die anderen Paare bleiben, blass</translation>
    </message>
    <message>
        <source>previous curves</source>
        <translation>vorige Kurven</translation>
    </message>
    <message>
        <source>Remove the faint reference curves</source>
        <translation>Blasse Referenzkurven entfernen</translation>
    </message>
    <message>
        <source>Keep the present curves as faint reference below the live curves</source>
        <translation>Jetzige Kurven als blasse Referenz unter den Live-Kurven behalten</translation>
    </message>
    <message>
        <source>Triggered view (End: live)</source>
        <translation>Getriggerte Ansicht (Ende: live)</translation>
    </message>
    <message>
        <source>Paused in history (End: live)</source>
        <translation>Angehalten im Verlauf (Ende: live)</translation>
    </message>
    <message>
        <source>Choose the signals to plot</source>
        <translation>Darzustellende Signale wählen</translation>
    </message>
    <message>
        <source>Add a marker at this time</source>
        <translation>Marke zu diesem Zeitpunkt setzen</translation>
    </message>
    <message>
        <source>Two measuring cursors; drag them or use the arrow keys</source>
        <translation>Zwei Cursor zum Messen; ziehen oder mit Pfeiltasten bewegen</translation>
    </message>
    <message>
        <source>Show later data</source>
        <translation>Spätere Daten zeigen</translation>
    </message>
    <message>
        <source>Scroll forward</source>
        <translation>Vorwärts blättern</translation>
    </message>
    <message>
        <source>Show earlier data</source>
        <translation>Frühere Daten zeigen</translation>
    </message>
    <message>
        <source>Show a longer time span</source>
        <translation>Längere Zeitspanne zeigen</translation>
    </message>
    <message>
        <source>Show a shorter time span</source>
        <translation>Kürzere Zeitspanne zeigen</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Vorige Ansicht</translation>
    </message>
    <message>
        <source>Show the whole history</source>
        <translation>Ganzen Verlauf zeigen</translation>
    </message>
    <message>
        <source>Fit the value axes; in a paused view, show the whole history</source>
        <translation>Wertachsen einpassen; bei angehaltener Ansicht ganzen Verlauf zeigen</translation>
    </message>
    <message>
        <source>Keep the latest sample in view</source>
        <translation>Neuesten Messwert im Bild behalten</translation>
    </message>
    <message>
        <source>Pause view (recording continues)</source>
        <translation>Ansicht anhalten (Aufzeichnung läuft weiter)</translation>
    </message>
    <message>
        <source>Live values of %1</source>
        <translation>Laufende Werte: %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Zoom back</source>
        <translation>Zoom zurück</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Scroll back</source>
        <translation>Zurückblättern</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Cursor A</source>
        <translation>Cursor A</translation>
    </message>
    <message>
        <source>Arrow keys move cursor A</source>
        <translation>Pfeiltasten bewegen Cursor A</translation>
    </message>
    <message>
        <source>Cursor B</source>
        <translation>Cursor B</translation>
    </message>
    <message>
        <source>Arrow keys move cursor B</source>
        <translation>Pfeiltasten bewegen Cursor B</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Add signals</source>
        <translation>Signale hinzufügen</translation>
    </message>
    <message>
        <source>Following, %1 s</source>
        <translation>Folgt, %1 s</translation>
    </message>
    <message>
        <source>Keep as reference</source>
        <translation>Als Referenz behalten</translation>
    </message>
    <message>
        <source>Remove the reference</source>
        <translation>Referenz entfernen</translation>
    </message>
    <message>
        <source>Remove the reference: %1</source>
        <translation>Referenz entfernen: %1</translation>
    </message>
    <message>
        <source>New cursor pair</source>
        <translation>Neues Cursorpaar</translation>
    </message>
    <message>
        <source>Remove the cursor pair</source>
        <translation>Cursorpaar entfernen</translation>
    </message>
    <message>
        <source>Next cursor pair</source>
        <translation>Nächstes Cursorpaar</translation>
    </message>
    <message>
        <source>Previous cursor pair</source>
        <translation>Voriges Cursorpaar</translation>
    </message>
    <message>
        <source>Name the cursor pair</source>
        <translation>Cursorpaar benennen</translation>
    </message>
    <message>
        <source>Go to the cursor pair</source>
        <translation>Zum Cursorpaar gehen</translation>
    </message>
    <message>
        <source>Bring the cursor pair here</source>
        <translation>Cursorpaar hierher holen</translation>
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
        <source>Time axis of %1</source>
        <translation>Zeitachse von %1</translation>
    </message>
    <message>
        <source>Own time axis</source>
        <translation>Eigene Zeitachse</translation>
    </message>
    <message>
        <source>One time axis for all plots</source>
        <translation>Eine Zeitachse für alle Diagramme</translation>
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
        <source>Plot to the left</source>
        <translation>Diagramm nach links</translation>
    </message>
    <message>
        <source>Remove the plot</source>
        <translation>Diagramm entfernen</translation>
    </message>
    <message>
        <source>Marker with a note</source>
        <translation>Marke mit Notiz</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>Nächste Marke</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>Vorige Marke</translation>
    </message>
    <message>
        <source>Remove the marker</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>List of markers</source>
        <translation>Liste der Marken</translation>
    </message>
    <message>
        <source>Zoom the values in</source>
        <translation>Werte vergrößern</translation>
    </message>
    <message>
        <source>Zoom the values out</source>
        <translation>Werte verkleinern</translation>
    </message>
    <message>
        <source>Fit the values</source>
        <translation>Werte einpassen</translation>
    </message>
    <message>
        <source>Taller plot</source>
        <translation>Diagramm höher</translation>
    </message>
    <message>
        <source>Shorter plot</source>
        <translation>Diagramm niedriger</translation>
    </message>
    <message>
        <source>Wider column</source>
        <translation>Spalte breiter</translation>
    </message>
    <message>
        <source>Narrower column</source>
        <translation>Spalte schmaler</translation>
    </message>
    <message>
        <source>Equal sizes</source>
        <translation>Gleiche Größen</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LookMenu</name>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Ochre</source>
        <translation>Ocker</translation>
    </message>
    <message>
        <source>Light blue</source>
        <translation>Hellblau</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Durchgezogen</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>Gestrichelt</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Gepunktet</translation>
    </message>
    <message>
        <source>Dash-dot</source>
        <translation>Strichpunktiert</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>Automatic colour and line</source>
        <translation>Farbe und Linie automatisch</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Line of %1</source>
        <translation>Linie von %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LogTableModel</name>
    <message>
        <source>Device time, as in its recordings</source>
        <translation>Gerätezeit, wie in den Aufzeichnungen</translation>
    </message>
    <message>
        <source>Local time of this computer</source>
        <translation>Ortszeit dieses Computers</translation>
    </message>
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
        <source>Clock</source>
        <translation>Uhrzeit</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LogView</name>
    <message>
        <source>Delete all messages</source>
        <translation>Alle Meldungen löschen</translation>
    </message>
    <message>
        <source>Lowest level of messages shown</source>
        <translation>Niedrigste gezeigte Meldungsstufe</translation>
    </message>
    <message>
        <source>Info and above</source>
        <translation>Info und höher</translation>
    </message>
    <message>
        <source>Show only messages with this text</source>
        <translation>Nur Meldungen mit diesem Text zeigen</translation>
    </message>
    <message>
        <source>Filter messages</source>
        <translation>Meldungen filtern</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
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
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::MarkerBar</name>
    <message>
        <source>All markers by time (Ctrl+J); J selects the next one</source>
        <translation>Alle Marken nach der Zeit (Strg+J); J wählt die nächste</translation>
    </message>
    <message>
        <source>Deselect the marker</source>
        <translation>Auswahl der Marke aufheben</translation>
    </message>
    <message>
        <source>Text of the marker; Enter saves it, Esc cancels</source>
        <translation>Text der Marke; Eingabetaste speichert, Esc bricht ab</translation>
    </message>
    <message>
        <source>Note of the selected marker</source>
        <translation>Notiz der gewählten Marke</translation>
    </message>
    <message>
        <source>Time of the selected marker</source>
        <translation>Zeit der gewählten Marke</translation>
    </message>
    <message>
        <source>List of markers</source>
        <translation>Liste der Marken</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Close the marker&apos;s row</source>
        <translation>Zeile der Marke schließen</translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n Marke</numerusform>
            <numerusform>%n Marken</numerusform>
        </translation>
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
        <source>No new value from the device; last value shown</source>
        <translation>Kein neuer Wert vom Gerät; letzter Wert gezeigt</translation>
    </message>
    <message>
        <source>%1, old</source>
        <translation>%1, alt</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::NumberWords</name>
    <message>
        <source>&apos;%1&apos; is ambiguous. Use &apos;%2&apos; before the decimals and no thousands separators.</source>
        <translation>„%1“ ist mehrdeutig. „%2“ vor den Nachkommastellen und keine Tausendertrennzeichen verwenden.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not allowed in a number. Use digits, a sign, &apos;%2&apos; before the decimals and e for a power of ten.</source>
        <translation>„%1“ ist in einer Zahl nicht erlaubt. Ziffern, Vorzeichen, „%2“ vor den Nachkommastellen und e für Zehnerpotenzen verwenden.</translation>
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
        <source>Angle unit for display and input</source>
        <translation>Winkeleinheit für Anzeige und Eingabe</translation>
    </message>
    <message>
        <source>Show only values edited here or changed on the device</source>
        <translation>Nur Werte zeigen, die hier oder im Gerät geändert wurden</translation>
    </message>
    <message>
        <source>Set every value to its default; nothing is written yet</source>
        <translation>Jeden Wert auf seine Vorgabe setzen; noch wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Discard the edits and show the device values</source>
        <translation>Änderungen verwerfen und Gerätewerte zeigen</translation>
    </message>
    <message>
        <source>Select a parameter to see its description.</source>
        <translation>Parameter wählen, um seine Beschreibung zu sehen.</translation>
    </message>
    <message>
        <source>read-only</source>
        <translation>nur lesbar</translation>
    </message>
    <message>
        <source>changes together with the other gains in one control cycle</source>
        <translation>ändert sich zusammen mit den übrigen Reglerparametern in einem Regelzyklus</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>%1 to %2 %3, default %4</source>
        <translation>%1 bis %2 %3, Vorgabe %4</translation>
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
        <source>Defaults</source>
        <translation>Vorgaben</translation>
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
        <source>%1 must be a whole number, not %2.</source>
        <translation>%1 muss eine ganze Zahl sein, nicht %2.</translation>
    </message>
    <message>
        <source>%1 is read-only.</source>
        <translation>%1 ist nur lesbar.</translation>
    </message>
    <message>
        <source>Allowed: %1 to %2.</source>
        <translation>Erlaubt: %1 bis %2.</translation>
    </message>
    <message>
        <source>Read-only value</source>
        <translation>Nur lesbarer Wert</translation>
    </message>
    <message>
        <source>Edited, not written yet; device value: %1</source>
        <translation>Bearbeitet, noch nicht geschrieben; Wert im Gerät: %1</translation>
    </message>
    <message>
        <source>Device disconnected; last reported value</source>
        <translation>Gerät getrennt; letzter gemeldeter Wert</translation>
    </message>
    <message>
        <source>Changed outside this window: %1 before, %2 now</source>
        <translation>Außerhalb dieses Fensters geändert: vorher %1, jetzt %2</translation>
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
        <source>%1: “%2” is not a number.</source>
        <translation>%1: „%2“ ist keine Zahl.</translation>
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
        <source>Cancel and restore the previous state</source>
        <translation>Abbrechen und vorigen Zustand wiederherstellen</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
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
    <message>
        <source>angle unknown</source>
        <translation>Winkel unbekannt</translation>
    </message>
    <message>
        <source>as measured by the Hall sensors</source>
        <translation>wie von den Hall-Sensoren gemessen</translation>
    </message>
    <message numerus="yes">
        <source>%n separate magnets</source>
        <translation>
            <numerusform>%n einzelner Magnet</numerusform>
            <numerusform>%n einzelne Magnete</numerusform>
        </translation>
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
        <source>%1 (old); field: %2</source>
        <translation>%1 (alt); Feld: %2</translation>
    </message>
    <message>
        <source>%1; field: %2</source>
        <translation>%1; Feld: %2</translation>
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
    <message>
        <source>Hall A</source>
        <translation>Hall A</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>Hall B</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ShareSplitter</name>
    <message>
        <source>Drag to change the sizes; double-click for equal sizes</source>
        <translation>Ziehen ändert die Größen; Doppelklick macht sie gleich</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::SpectrogramView</name>
    <message>
        <source>No data to show</source>
        <translation>Keine Daten zu zeigen</translation>
    </message>
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
        <source>highest %1</source>
        <translation>höchster Wert %1</translation>
    </message>
    <message>
        <source>%1 s, %2 Hz: %3 %4</source>
        <translation>%1 s, %2 Hz: %3 %4</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::SphereView</name>
    <message>
        <source>orientation unknown</source>
        <translation>Orientierung unbekannt</translation>
    </message>
    <message>
        <source>ambiguous: last orientation shown</source>
        <translation>mehrdeutig: letzte Orientierung gezeigt</translation>
    </message>
    <message>
        <source>doubtful: readings do not fit the model</source>
        <translation>zweifelhaft: Messwerte passen nicht zum Modell</translation>
    </message>
    <message>
        <source>old values</source>
        <translation>alte Werte</translation>
    </message>
    <message>
        <source>Rotor, sensors and shaft from the side</source>
        <translation>Rotor, Sensoren und Welle in der Ansicht</translation>
    </message>
    <message>
        <source>shaft %1 degrees from Z; %2</source>
        <translation>Welle %1 Grad von Z; %2</translation>
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
        <source>Slope from cursor A to B, per second</source>
        <translation>Steigung von Cursor A bis B, je Sekunde</translation>
    </message>
    <message>
        <source>Peak to peak: maximum minus minimum</source>
        <translation>Spitze-Spitze: Maximum minus Minimum</translation>
    </message>
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
        <source>Slope/s</source>
        <translation>Steigung/s</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StatusStrip</name>
    <message>
        <source>Armed: %1</source>
        <translation>Freigegeben: %1</translation>
    </message>
    <message>
        <source>Simulated device inside the program; no real motion</source>
        <translation>Simuliertes Gerät im Programm; keine echte Bewegung</translation>
    </message>
    <message>
        <source>%1, recording, %2</source>
        <translation>%1, Aufzeichnung, %2</translation>
    </message>
    <message>
        <source>Recorded samples; no device is connected</source>
        <translation>Aufgezeichnete Messwerte; kein Gerät ist verbunden</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Geöffnet</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>AUFZEICHNUNG</translation>
    </message>
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
        <source>%1 STOP and Esc still work. To continue: Release, next to the state.</source>
        <translation>%1 STOPP und Esc wirken weiter. Fortfahren: „Aufheben“ neben dem Zustand.</translation>
    </message>
    <message>
        <source>Stopped; press again to repeat the stop</source>
        <translation>Gestoppt; erneut drücken wiederholt den Stopp</translation>
    </message>
    <message>
        <source>Software stop: current off, latched until released (Esc)</source>
        <translation>Software-Stopp: Strom aus, verriegelt bis zum Aufheben (Esc)</translation>
    </message>
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
</context>
<context>
    <name>halbench::widgets::TimeAxisBar</name>
    <message>
        <source>time relative to the event [s]</source>
        <translation>Zeit relativ zum Ereignis [s]</translation>
    </message>
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
    <name>halbench::widgets::UnitMenu</name>
    <message>
        <source>Default of the preferences (%1)</source>
        <translation>Vorgabe der Einstellungen (%1)</translation>
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
        <source>enter the required phase margin</source>
        <translation>gewünschte Phasenreserve eingeben</translation>
    </message>
    <message>
        <source>enter the required bandwidth</source>
        <translation>gewünschte Bandbreite eingeben</translation>
    </message>
    <message>
        <source>steady speeds alone do not determine the inertia: identify again with run-ups and coast-downs, or enter the given inertia J</source>
        <translation>stationäre Drehzahlen allein bestimmen das Trägheitsmoment nicht: erneut mit Hoch- und Ausläufen identifizieren oder das bekannte Trägheitsmoment J eingeben</translation>
    </message>
    <message>
        <source>identify the bare motor again with empty constants</source>
        <translation>den bloßen Motor erneut ohne bekannte Konstanten identifizieren</translation>
    </message>
    <message>
        <source>choose Identify again and enter the given inertia J or the given torque constant φ</source>
        <translation>„Neu identifizieren“ wählen und das bekannte Trägheitsmoment J oder die bekannte Drehmomentkonstante φ eingeben</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::PlatenDrawing</name>
    <message>
        <source>H%1</source>
        <translation>H%1</translation>
    </message>
    <message>
        <source>error ×1000</source>
        <translation>Fehler ×1000</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außerhalb</translation>
    </message>
    <message>
        <source>no position is controlled</source>
        <translation>keine Lage geregelt</translation>
    </message>
    <message>
        <source>Field at a chip</source>
        <translation>Feld am Chip</translation>
    </message>
    <message>
        <source>Residual ×%1</source>
        <translation>Residuum ×%1</translation>
    </message>
    <message>
        <source>Force of a pair</source>
        <translation>Kraft eines Paars</translation>
    </message>
    <message>
        <source>Sum of the forces</source>
        <translation>Summe der Kräfte</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>True place</source>
        <translation>Wahrer Ort</translation>
    </message>
    <message>
        <source>Bz −%1 … %1 T at z = %2 mm</source>
        <translation>Bz −%1 … %1 T bei z = %2 mm</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::PlatenTable</name>
    <message>
        <source>Pose</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>±%1 A</source>
        <translation>±%1 A</translation>
    </message>
    <message>
        <source>to %1 °C</source>
        <translation>bis %1 °C</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>Spule</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>Chip %1</source>
        <translation>Chip %1</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>Chi-square</source>
        <translation>Chi-Quadrat</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Hubkraft</translation>
    </message>
    <message>
        <source>limited</source>
        <translation>begrenzt</translation>
    </message>
    <message>
        <source>Reach left</source>
        <translation>Restweg</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::PlatenView</name>
    <message>
        <source>Sho&amp;w all</source>
        <translation>Alles &amp;zeigen</translation>
    </message>
    <message>
        <source>Show the whole magnet matrix (Alt+W, Home)</source>
        <translation>Die ganze Magnetmatrix zeigen (Alt+Z, Pos1)</translation>
    </message>
    <message>
        <source>F&amp;ollow</source>
        <translation>F&amp;olgen</translation>
    </message>
    <message>
        <source>Keep the platen in the middle of the map (Alt+O)</source>
        <translation>Die Platte in der Mitte der Karte halten (Alt+O)</translation>
    </message>
    <message>
        <source>&amp;Clear path</source>
        <translation>Weg lös&amp;chen</translation>
    </message>
    <message>
        <source>Forget the way that the platen went (Alt+C)</source>
        <translation>Den Weg der Platte vergessen (Alt+C)</translation>
    </message>
    <message>
        <source>pose not known</source>
        <translation>Lage nicht bekannt</translation>
    </message>
    <message>
        <source>Pitch cell %1, %2</source>
        <translation>Teilungszelle %1, %2</translation>
    </message>
    <message>
        <source>homed</source>
        <translation>referenziert</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>nicht referenziert</translation>
    </message>
    <message>
        <source>old values</source>
        <translation>alte Werte</translation>
    </message>
    <message>
        <source>Platen over the magnet matrix</source>
        <translation>Platte über der Magnetmatrix</translation>
    </message>
    <message>
        <source>platen at x %1 mm, y %2 mm, turned by %3 mrad</source>
        <translation>Platte bei x %1 mm, y %2 mm, um %3 mrad gedreht</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::RotorPicture</name>
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
        <source>Field of the individual magnets (Alt+G)</source>
        <translation>Feld der einzelnen Magnete (Alt+G)</translation>
    </message>
    <message>
        <source>Meas&amp;ured</source>
        <translation>Geme&amp;ssen</translation>
    </message>
    <message>
        <source>Direction and magnitude measured by the Hall sensors (Alt+U)</source>
        <translation>Richtung und Betrag laut Hall-Sensoren (Alt+S)</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::SpherePicture</name>
    <message>
        <source>&amp;Clear path</source>
        <translation>Weg lös&amp;chen</translation>
    </message>
    <message>
        <source>Clear the path of the shaft (Alt+C)</source>
        <translation>Weg der Welle löschen (Alt+C)</translation>
    </message>
    <message>
        <source>α %1°, β %2°, γ %3° (γ about Z first, then β about Y, then α about X)</source>
        <translation>α %1°, β %2°, γ %3° (erst γ um Z, dann β um Y, dann α um X)</translation>
    </message>
    <message>
        <source>q %1 mT, chi-square %2, 95 % cone ±%3°</source>
        <translation>q %1 mT, Chi-Quadrat %2, 95-%-Kegel ±%3°</translation>
    </message>
    <message>
        <source>simulated truth: α %1°, β %2°, γ %3°; error %4°</source>
        <translation>simulierte Wahrheit: α %1°, β %2°, γ %3°; Fehler %4°</translation>
    </message>
    <message>
        <source>changes to another orientation with the same field: %1</source>
        <translation>Wechsel zu einer anderen Orientierung mit demselben Feld: %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::FileDrop</name>
    <message>
        <source>Drop a recording or table (.csv, .txt, .tsv, .mf4) or a project (.toml).</source>
        <translation>Eine Aufzeichnung oder Tabelle (.csv, .txt, .tsv, .mf4) oder ein Projekt (.toml) ablegen.</translation>
    </message>
    <message>
        <source>%1 cannot be opened by dropping it</source>
        <translation>%1 lässt sich nicht durch Ablegen öffnen</translation>
    </message>
    <message>
        <source>Drop one recording or one project.</source>
        <translation>Eine Aufzeichnung oder ein Projekt ablegen.</translation>
    </message>
    <message>
        <source>One file at a time</source>
        <translation>Nur eine Datei auf einmal</translation>
    </message>
</context>
<context>
    <name>halbench::app::ShortcutList</name>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Funktion</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Close the list (Esc, which also stops)</source>
        <translation>Liste schließen (Esc, das auch stoppt)</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Shows rows that contain all words</source>
        <translation>Zeigt Zeilen, die alle Wörter enthalten</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>Tastenkürzel suchen</translation>
    </message>
    <message>
        <source>Search keys, functions, panels</source>
        <translation>Tasten, Funktionen, Panels suchen</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
</context>
<context>
    <name>halbench::app::AboutDialog</name>
    <message>
        <source>Copy the versions for a fault report</source>
        <translation>Versionen für einen Fehlerbericht kopieren</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>Ko&amp;pieren</translation>
    </message>
    <message>
        <source>Close (Esc, which also stops)</source>
        <translation>Schließen (Esc, das auch stoppt)</translation>
    </message>
    <message>
        <source>Free software, GNU General Public License, version 3. No warranty.</source>
        <translation>Freie Software, GNU General Public License, Version 3. Ohne Gewähr.</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>Workstation for precision Lorentz-force actuators: watch, calibrate, identify, tune, verify and record.</source>
        <translation>Arbeitsplatz für präzise Lorentz-Aktoren: beobachten, kalibrieren, identifizieren, einstellen, prüfen und aufzeichnen.</translation>
    </message>
    <message>
        <source>About Halbench</source>
        <translation>Über Halbench</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesFrequencyFigures</name>
    <message>
        <source>coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Open loop of each axis, the others closed</source>
        <translation>Offener Kreis jeder Achse, die anderen geschlossen</translation>
    </message>
    <message>
        <source>Response to the effort of another axis, relative to its own</source>
        <translation>Antwort auf die Stellgröße einer anderen Achse, bezogen auf die eigene</translation>
    </message>
    <message>
        <source>relative response</source>
        <translation>bezogene Antwort</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Largest singular values of all loops together</source>
        <translation>Größte Singulärwerte aller Kreise zusammen</translation>
    </message>
    <message>
        <source>singular value</source>
        <translation>Singulärwert</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesFrequencyPanel</name>
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
        <source>Measures the loops of all axes together, with the gains of the device: margins of each axis with 95 % intervals, and the coupling between them.</source>
        <translation>Misst die Regelkreise aller Achsen zusammen, mit den Verstärkungen des Geräts: Reserven jeder Achse mit 95-%-Intervallen und die Kopplung zwischen ihnen.</translation>
    </message>
    <message>
        <source>The actuator is excited around its position. STOP (Esc) and Cancel end the run; mode, windows and generator are restored, the gains are not changed.</source>
        <translation>Der Aktor wird um seine Lage angeregt. STOPP (Esc) und Abbrechen beenden den Lauf; Betriebsart, Fenster und Generator werden wiederhergestellt, die Verstärkungen bleiben unverändert.</translation>
    </message>
    <message>
        <source>Computing the response</source>
        <translation>Berechnet den Frequenzgang</translation>
    </message>
    <message>
        <source>Start measurement</source>
        <translation>Messung starten</translation>
    </message>
    <message>
        <source>The actuator moves (Ctrl+Return); Esc stops it</source>
        <translation>Der Aktor bewegt sich (Strg+Eingabe); Esc hält ihn an</translation>
    </message>
    <message>
        <source>Save response…</source>
        <translation>Frequenzgang speichern …</translation>
    </message>
    <message>
        <source>Save the matrix of responses as a file</source>
        <translation>Die Matrix der Frequenzgänge als Datei speichern</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>Tabelle speichern …</translation>
    </message>
    <message>
        <source>Save the points with error and coherence as CSV</source>
        <translation>Punkte mit Fehler und Kohärenz als CSV speichern</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>Zurück zu den Einstellungen; dieses Ergebnis bleibt bis zum nächsten Lauf</translation>
    </message>
    <message>
        <source>Lowest frequency [Hz]</source>
        <translation>Niedrigste Frequenz [Hz]</translation>
    </message>
    <message>
        <source>Highest frequency [Hz]</source>
        <translation>Höchste Frequenz [Hz]</translation>
    </message>
    <message>
        <source>Effort [%]</source>
        <translation>Stellgröße [%]</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Perioden</translation>
    </message>
    <message>
        <source>One period of the excitation lasts at least two of this frequency</source>
        <translation>Eine Periode der Anregung dauert mindestens zwei Perioden dieser Frequenz</translation>
    </message>
    <message>
        <source>At most 45 % of the sampling rate of the loops</source>
        <translation>Höchstens 45 % der Abtastrate der Regelkreise</translation>
    </message>
    <message>
        <source>Amplitude of a sine of the same rms, of the largest effort of each axis; reduced where an axis would swing too far</source>
        <translation>Amplitude eines Sinus mit gleichem Effektivwert, von der größten Stellgröße jeder Achse; verringert, wo eine Achse zu weit schwingen würde</translation>
    </message>
    <message>
        <source>Periods of each experiment that are averaged; the intervals shrink with the square root</source>
        <translation>Gemittelte Perioden jedes Versuchs; die Intervalle schrumpfen mit der Wurzel</translation>
    </message>
    <message>
        <source>Excited axes</source>
        <translation>Angeregte Achsen</translation>
    </message>
    <message>
        <source>All at once shows the coupling; the loops of the others stay closed</source>
        <translation>Alle zugleich zeigt die Kopplung; die Kreise der anderen bleiben geschlossen</translation>
    </message>
    <message>
        <source>Measured margins</source>
        <translation>Gemessene Reserven</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Regelkreise</translation>
    </message>
    <message>
        <source>Open loop of each axis while the others are closed, and coherence</source>
        <translation>Offener Kreis jeder Achse, während die anderen geschlossen sind, und Kohärenz</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>Kopplung</translation>
    </message>
    <message>
        <source>Response of each axis to the effort of another, relative to its own</source>
        <translation>Antwort jeder Achse auf die Stellgröße einer anderen, bezogen auf die eigene</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>Alle zusammen</translation>
    </message>
    <message>
        <source>Largest singular values of S and T over frequency</source>
        <translation>Größte Singulärwerte von S und T über der Frequenz</translation>
    </message>
    <message>
        <source>Pictures of the frequency response</source>
        <translation>Bilder des Frequenzgangs</translation>
    </message>
    <message>
        <source>all at once</source>
        <translation>alle zugleich</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Enter a number</source>
        <translation>Geben Sie eine Zahl ein</translation>
    </message>
    <message>
        <source>Connect a device with several axes.</source>
        <translation>Verbinden Sie ein Gerät mit mehreren Achsen.</translation>
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
        <source>Measurement cancelled. Nothing was changed.</source>
        <translation>Messung abgebrochen. Nichts wurde geändert.</translation>
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
    <message>
        <source>Use in Tune</source>
        <translation>In Auslegung verwenden</translation>
    </message>
    <message>
        <source>Show the points in the open loop of each axis in Tune</source>
        <translation>Punkte im offenen Kreis jeder Achse der Auslegung zeigen</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesFrequencyWords</name>
    <message>
        <source>not given: largest at the edge of the band</source>
        <translation>nicht angegeben: am größten am Rand des Bands</translation>
    </message>
    <message>
        <source>not given: no frequency with every axis coherent</source>
        <translation>nicht angegeben: keine Frequenz, bei der jede Achse kohärent ist</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>at %1 Hz</source>
        <translation>bei %1 Hz</translation>
    </message>
    <message>
        <source>Strongest coupling: full effort of %1 moves %2 by %3 % of what its own full effort does, at %4 Hz.</source>
        <translation>Stärkste Kopplung: Die volle Stellgröße von %1 bewegt %2 um %3 % dessen, was die eigene volle Stellgröße bewirkt, bei %4 Hz.</translation>
    </message>
    <message>
        <source>No coupling between the axes was seen above the scatter.</source>
        <translation>Zwischen den Achsen ist keine Kopplung über der Streuung zu erkennen.</translation>
    </message>
    <message>
        <source>The loops hold the position; %1 are excited from %2 to %3 Hz with %4 % of their largest effort, for %5 minutes of device time.</source>
        <translation>Die Regelkreise halten die Lage; %1: Anregung von %2 bis %3 Hz mit %4 % der größten Stellgröße, %5 Minuten Gerätezeit.</translation>
    </message>
    <message>
        <source>The loops are measured with the gains of the device, which are not changed. Everything else is restored.</source>
        <translation>Gemessen wird mit den Verstärkungen des Geräts, die unverändert bleiben. Alles andere wird wiederhergestellt.</translation>
    </message>
    <message>
        <source>%1: phase margin</source>
        <translation>%1: Phasenreserve</translation>
    </message>
    <message>
        <source>%1: gain margin</source>
        <translation>%1: Amplitudenreserve</translation>
    </message>
    <message>
        <source>peak of the largest singular value of S</source>
        <translation>Spitze des größten Singulärwerts von S</translation>
    </message>
    <message>
        <source>peak of the largest singular value of T</source>
        <translation>Spitze des größten Singulärwerts von T</translation>
    </message>
    <message>
        <source>%1: %2 of %3 frequencies have a coherence of at least %4.</source>
        <translation>%1: %2 von %3 Frequenzen haben eine Kohärenz von mindestens %4.</translation>
    </message>
    <message>
        <source>S and T: positions in units of the test steps of the axes.</source>
        <translation>S und T: Lagen in Einheiten der Prüfsprünge der Achsen.</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesIdentifyPanel</name>
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
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Finds damping, gain and friction of every axis and the constants of the actuator with their 95 % intervals, by moving it to and fro while all axes are excited.</source>
        <translation>Findet Dämpfung, Verstärkung und Reibung jeder Achse und die Konstanten des Aktors mit ihren 95-%-Intervallen, indem er hin und her bewegt wird, während alle Achsen angeregt sind.</translation>
    </message>
    <message>
        <source>The actuator moves. STOP (Esc) and Cancel end it; gains, limits, mode, windows and generator are restored.</source>
        <translation>Der Aktor bewegt sich. STOPP (Esc) und Abbrechen beenden es; Verstärkungen, Grenzen, Betriebsart, Fenster und Generator werden wiederhergestellt.</translation>
    </message>
    <message>
        <source>Computing the result</source>
        <translation>Berechnet das Ergebnis</translation>
    </message>
    <message>
        <source>Start identification</source>
        <translation>Identifikation starten</translation>
    </message>
    <message>
        <source>The actuator moves (Ctrl+Return); Esc stops it</source>
        <translation>Der Aktor bewegt sich (Strg+Eingabe); Esc hält ihn an</translation>
    </message>
    <message>
        <source>Tune with this model</source>
        <translation>Mit diesem Modell auslegen</translation>
    </message>
    <message>
        <source>Go on to the gains for these axes</source>
        <translation>Weiter zu den Verstärkungen für diese Achsen</translation>
    </message>
    <message>
        <source>Save as model…</source>
        <translation>Als Modell speichern …</translation>
    </message>
    <message>
        <source>Save a file for the commands tune and analyse</source>
        <translation>Datei für die Befehle tune und analyse speichern</translation>
    </message>
    <message>
        <source>Identify again</source>
        <translation>Neu identifizieren</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>Zurück zu den Einstellungen; dieses Ergebnis bleibt bis zum nächsten Lauf</translation>
    </message>
    <message>
        <source>Identified values</source>
        <translation>Identifizierte Werte</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Axes of the model</source>
        <translation>Achsen des Modells</translation>
    </message>
    <message>
        <source>Axes of the model; all axes move during the run</source>
        <translation>Achsen des Modells; während des Laufs bewegen sich alle</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>%1 in %2, if known. Without a known constant only ratios are identified, which is enough for tuning</source>
        <translation>%1 in %2, falls bekannt. Ohne bekannte Konstante werden nur Verhältnisse identifiziert, was zum Auslegen genügt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>Berichtigen Sie es, oder lassen Sie es leer</translation>
    </message>
    <message>
        <source>Connect a device with several axes.</source>
        <translation>Verbinden Sie ein Gerät mit mehreren Achsen.</translation>
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
        <source>Identification cancelled. Nothing was changed.</source>
        <translation>Identifikation abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Tuning uses damping rate, acceleration per effort and friction of each axis.</source>
        <translation>Das Auslegen verwendet Dämpfungsrate, Beschleunigung je Stellgröße und Reibung jeder Achse.</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesIdentifyWords</name>
    <message>
        <source>%1: damping rate</source>
        <translation>%1: Dämpfungsrate</translation>
    </message>
    <message>
        <source>%1: acceleration per effort</source>
        <translation>%1: Beschleunigung je Stellgröße</translation>
    </message>
    <message>
        <source>%1: friction, as effort</source>
        <translation>%1: Reibung, als Stellgröße</translation>
    </message>
    <message>
        <source>Motion of %1 for %2 minutes of device time, up to %3 A in a coil, maximum coil temperature %4 °C.</source>
        <translation>Bewegung von %1, %2 Minuten Gerätezeit, bis zu %3 A in einer Spule, Spulentemperatur höchstens %4 °C.</translation>
    </message>
    <message>
        <source>The board monitors its windows. Gains, limits and references are restored in every case.</source>
        <translation>Das Steuergerät überwacht seine Fenster. Verstärkungen, Grenzen und Sollwerte werden in jedem Fall wiederhergestellt.</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisFigures</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>effort</source>
        <translation>Stellgröße</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Führungsgröße</translation>
    </message>
    <message>
        <source>Predicted step of axis %1</source>
        <translation>Vorhergesagter Sprung der Achse %1</translation>
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
        <source>other axes</source>
        <translation>andere Achsen</translation>
    </message>
    <message>
        <source>Verification step of axis %1</source>
        <translation>Verifikationssprung der Achse %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisGainEditor</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Enter a number</source>
        <translation>Geben Sie eine Zahl ein</translation>
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
        <source>Derivative gain</source>
        <translation>Differentialverstärkung</translation>
    </message>
    <message>
        <source>Set-point weight b of the proportional part</source>
        <translation>Sollwertgewichtung b des P-Anteils</translation>
    </message>
    <message>
        <source>Set-point weight c of the derivative part</source>
        <translation>Sollwertgewichtung c des D-Anteils</translation>
    </message>
    <message>
        <source>Time constant of the derivative&apos;s filter</source>
        <translation>Zeitkonstante des Filters am D-Anteil</translation>
    </message>
    <message>
        <source>Weight b</source>
        <translation>Gewicht b</translation>
    </message>
    <message>
        <source>Weight c</source>
        <translation>Gewicht c</translation>
    </message>
    <message>
        <source>Filter T_f</source>
        <translation>Filter T_f</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisResponseButton</name>
    <message>
        <source>Measured response…</source>
        <translation>Messung …</translation>
    </message>
    <message>
        <source>Show a measured frequency response in the open loops</source>
        <translation>Einen gemessenen Frequenzgang in den offenen Kreisen zeigen</translation>
    </message>
    <message>
        <source>Open a measured response</source>
        <translation>Gemessenen Frequenzgang öffnen</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>Frequenzgang (*.json)</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisTunePanel</name>
    <message>
        <source>Verification: %1</source>
        <translation>Nachweis: %1</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis of the loop shown</source>
        <translation>Achse des gezeigten Regelkreises</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Verstärkungen</translation>
    </message>
    <message>
        <source>Design method for the gains of this axis</source>
        <translation>Auslegungsverfahren für die Verstärkungen dieser Achse</translation>
    </message>
    <message>
        <source>Axes to apply</source>
        <translation>Zu übernehmende Achsen</translation>
    </message>
    <message>
        <source>Gains that Apply and verify writes, in one transaction</source>
        <translation>Verstärkungen, die „Übernehmen, prüfen“ in einer Transaktion schreibt</translation>
    </message>
    <message>
        <source>all axes</source>
        <translation>alle Achsen</translation>
    </message>
    <message>
        <source>this axis</source>
        <translation>diese Achse</translation>
    </message>
    <message>
        <source>Apply and verify</source>
        <translation>Übernehmen, prüfen</translation>
    </message>
    <message>
        <source>Write the gains in one transaction, then verify each axis with a step; Esc stops it</source>
        <translation>Schreibt die Verstärkungen in einer Transaktion und prüft dann jede Achse mit einem Sprung; Esc hält an</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Write the gains from before the last apply</source>
        <translation>Schreibt die Verstärkungen von vor dem letzten Übernehmen</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>Offener Kreis</translation>
    </message>
    <message>
        <source>Bode, Nyquist and Nichols plot, and sensitivity</source>
        <translation>Bode-, Nyquist- und Nichols-Diagramm sowie Empfindlichkeit</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>The test step with friction and effort limit</source>
        <translation>Der Testsprung mit Reibung und Stellgrößengrenze</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Nachweis</translation>
    </message>
    <message>
        <source>Measured step over its prediction, after Apply and verify</source>
        <translation>Gemessener Sprung über seiner Vorhersage, nach „Übernehmen, prüfen“</translation>
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
        <source>Cancelled. Previous gains restored.</source>
        <translation>Abgebrochen. Vorige Reglerparameter wiederhergestellt.</translation>
    </message>
    <message>
        <source>Applied, and every verification step went as predicted.</source>
        <translation>Übernommen, und jeder Verifikationssprung verlief wie vorhergesagt.</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Auslegen</translation>
    </message>
    <message>
        <source>The gains from before run again: a verification step did not go as predicted.</source>
        <translation>Die vorigen Verstärkungen gelten wieder: Ein Verifikationssprung verlief nicht wie vorhergesagt.</translation>
    </message>
    <message>
        <source>Previous gains restored.</source>
        <translation>Vorige Reglerparameter wiederhergestellt.</translation>
    </message>
    <message>
        <source>Remove the response</source>
        <translation>Messung entfernen</translation>
    </message>
    <message>
        <source>Show only predictions in the open loop of this axis</source>
        <translation>Im offenen Kreis dieser Achse nur Vorhersagen zeigen</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
    <message>
        <source>Measured response shown in the open loop of each axis, the others closed.</source>
        <translation>Gemessener Frequenzgang im offenen Kreis jeder Achse gezeigt, die anderen geschlossen.</translation>
    </message>
    <message>
        <source>%1 of %2 frequencies are coherent; the others are hollow.</source>
        <translation>%1 von %2 Frequenzen sind kohärent; die anderen sind hohl.</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisTargets</name>
    <message>
        <source>damping ratio</source>
        <translation>Dämpfungsgrad</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>Frequenz [rad/s]</translation>
    </message>
    <message>
        <source>bandwidth [Hz]</source>
        <translation>Bandbreite [Hz]</translation>
    </message>
    <message>
        <source>phase margin [°]</source>
        <translation>Phasenreserve [°]</translation>
    </message>
    <message>
        <source>chosen by the method</source>
        <translation>vom Verfahren gewählt</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisVerdict</name>
    <message>
        <source>Computing the loops</source>
        <translation>Regelkreise werden berechnet</translation>
    </message>
    <message>
        <source>All axes: %1</source>
        <translation>Alle Achsen: %1</translation>
    </message>
    <message>
        <source>Axis %1: %2</source>
        <translation>Achse %1: %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisGainFiles</name>
    <message>
        <source>Save gains…</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Save the gains of all axes to a file</source>
        <translation>Reglerparameter aller Achsen in einer Datei speichern</translation>
    </message>
    <message>
        <source>Open gains…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Propose the gains of a file; they are assessed first</source>
        <translation>Reglerparameter einer Datei vorschlagen; sie werden erst beurteilt</translation>
    </message>
    <message>
        <source>Open gains</source>
        <translation>Reglerparameter öffnen</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>Reglerparameter (*.json)</translation>
    </message>
    <message>
        <source>Gains of %1.</source>
        <translation>Reglerparameter aus %1.</translation>
    </message>
    <message>
        <source>It has none for %1, which keep their own.</source>
        <translation>Die Datei enthält keine für %1; dort bleiben die eigenen.</translation>
    </message>
    <message>
        <source>Save gains</source>
        <translation>Reglerparameter speichern</translation>
    </message>
</context>
<context>
    <name>halbench::app::TurnText</name>
    <message>
        <source>The rotor will turn in reverse at %1 rad/s, about %2 turns, for %3 minutes of device time.</source>
        <translation>Der Rotor wird sich rückwärts mit %1 rad/s drehen, etwa %2 Umdrehungen, %3 Minuten Gerätezeit lang.</translation>
    </message>
    <message>
        <source>The rotor will turn forward at %1 rad/s, about %2 turns, for %3 minutes of device time.</source>
        <translation>Der Rotor wird sich vorwärts mit %1 rad/s drehen, etwa %2 Umdrehungen, %3 Minuten Gerätezeit lang.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>List All Tabs</source>
        <translation>Alle Reiter anzeigen</translation>
    </message>
    <message>
        <source>Detach Group</source>
        <translation>Gruppe ablösen</translation>
    </message>
    <message>
        <source>Close Active Tab</source>
        <translation>Aktiven Reiter schließen</translation>
    </message>
    <message>
        <source>Close Group</source>
        <translation>Gruppe schließen</translation>
    </message>
    <message>
        <source>Close Tab</source>
        <translation>Reiter schließen</translation>
    </message>
</context>
<context>
    <name>ads::CDockAreaTitleBar</name>
    <message>
        <source>List All Tabs</source>
        <translation>Alle Reiter anzeigen</translation>
    </message>
    <message>
        <source>Detach Group</source>
        <translation>Gruppe ablösen</translation>
    </message>
    <message>
        <source>Close Active Tab</source>
        <translation>Aktiven Reiter schließen</translation>
    </message>
    <message>
        <source>Close Group</source>
        <translation>Gruppe schließen</translation>
    </message>
    <message>
        <source>Close Other Groups</source>
        <translation>Andere Gruppen schließen</translation>
    </message>
</context>
<context>
    <name>ads::CDockWidgetTab</name>
    <message>
        <source>Detach</source>
        <translation>Ablösen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close Others</source>
        <translation>Andere schließen</translation>
    </message>
    <message>
        <source>Close Tab</source>
        <translation>Reiter schließen</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::CopyMenu</name>
    <message>
        <source>Copy cell</source>
        <translation>Zelle kopieren</translation>
    </message>
    <message>
        <source>Copy rows</source>
        <translation>Zeilen kopieren</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabelle kopieren</translation>
    </message>
</context>
<context>
    <name>halbench::app::EstimatorPanel</name>
    <message>
        <source>Tensor</source>
        <translation>Tensor</translation>
    </message>
    <message>
        <source>Projector</source>
        <translation>Projektor</translation>
    </message>
    <message>
        <source>Projector + Gauss-Newton step</source>
        <translation>Projektor + Gauß-Newton-Schritt</translation>
    </message>
    <message>
        <source>Levenberg-Marquardt</source>
        <translation>Levenberg-Marquardt</translation>
    </message>
    <message>
        <source>Closed form, additive model</source>
        <translation>Geschlossene Form, additives Modell</translation>
    </message>
    <message>
        <source>Closed form + least squares</source>
        <translation>Geschlossene Form + kleinste Quadrate</translation>
    </message>
    <message>
        <source>Particle swarm, additive model</source>
        <translation>Partikelschwarm, additives Modell</translation>
    </message>
    <message>
        <source>Sensors of the comparison</source>
        <translation>Sensoren des Vergleichs</translation>
    </message>
    <message>
        <source>Readings from</source>
        <translation>Messwerte aus</translation>
    </message>
    <message>
        <source>Model that makes the readings of the sensors</source>
        <translation>Modell, das die Messwerte der Sensoren liefert</translation>
    </message>
    <message>
        <source>Physical field</source>
        <translation>Physikalisches Feld</translation>
    </message>
    <message>
        <source>Additive model</source>
        <translation>Additives Modell</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Noise of each reading, rms; at first that of the board</source>
        <translation>Rauschen je Messwert, effektiv; zuerst das des Geräts</translation>
    </message>
    <message>
        <source>Failure above</source>
        <translation>Misslungen ab</translation>
    </message>
    <message>
        <source>A pose with a larger error has failed</source>
        <translation>Eine Lage mit größerem Fehler ist misslungen</translation>
    </message>
    <message>
        <source>Harmonic passes</source>
        <translation>Harmonische Durchgänge</translation>
    </message>
    <message>
        <source>How often the board&apos;s harmonics are corrected; 0: never</source>
        <translation>Wie oft die Harmonischen korrigiert werden; 0: nie</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Equal seeds give equal poses and noise</source>
        <translation>Gleiche Startwerte: gleiche Lagen, gleiches Rauschen</translation>
    </message>
    <message>
        <source>Co&amp;mpare estimators</source>
        <translation>Schätzer &amp;vergleichen</translation>
    </message>
    <message>
        <source>Estimate all poses with each of them (Alt+M)</source>
        <translation>Alle Lagen mit jedem schätzen (Alt+V)</translation>
    </message>
    <message>
        <source>Comparing the estimators</source>
        <translation>Schätzer werden verglichen</translation>
    </message>
    <message>
        <source>Estimators compared</source>
        <translation>Verglichene Schätzer</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>rms error [°]</source>
        <translation>Fehler, effektiv [°]</translation>
    </message>
    <message>
        <source>Largest error [°]</source>
        <translation>Größter Fehler [°]</translation>
    </message>
    <message>
        <source>Shaft, rms [°]</source>
        <translation>Welle, effektiv [°]</translation>
    </message>
    <message>
        <source>Failures</source>
        <translation>Misslungen</translation>
    </message>
    <message>
        <source>Time per pose [µs]</source>
        <translation>Zeit je Lage [µs]</translation>
    </message>
    <message>
        <source>The comparison was cancelled.</source>
        <translation>Der Vergleich wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>nicht verwendbar</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Poses on which the estimators are compared</source>
        <translation>Lagen, an denen die Schätzer verglichen werden</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>Trajectory 1: tilt at Φ = 0°</source>
        <translation>Trajektorie 1: Kippen bei Φ = 0°</translation>
    </message>
    <message>
        <source>Trajectory 2: tilt at Φ = 90°</source>
        <translation>Trajektorie 2: Kippen bei Φ = 90°</translation>
    </message>
    <message>
        <source>Trajectory 3: around at Θ = 45°</source>
        <translation>Trajektorie 3: Umlauf bei Θ = 45°</translation>
    </message>
    <message>
        <source>Trajectory 4: spiral</source>
        <translation>Trajektorie 4: Spirale</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>Anzahl der Lagen</translation>
    </message>
    <message>
        <source>Spin γ</source>
        <translation>Drehung γ</translation>
    </message>
    <message>
        <source>Rotation about the shaft along a trajectory</source>
        <translation>Drehung um die Welle entlang einer Trajektorie</translation>
    </message>
    <message>
        <source>Noise that the recorded readings have; nothing is added</source>
        <translation>Rauschen der aufgezeichneten Messwerte; keines wird hinzugefügt</translation>
    </message>
    <message>
        <source>Rows of the recording</source>
        <translation>Zeilen der Aufzeichnung</translation>
    </message>
    <message>
        <source>The time is that of one thread of this computer.</source>
        <translation>Die Zeit ist die eines Threads dieses Rechners.</translation>
    </message>
    <message>
        <source>Errors are measured to the nearest of the four orientations with the same field.</source>
        <translation>Fehler gelten gegen die nächste der vier Orientierungen mit gleichem Feld.</translation>
    </message>
    <message>
        <source>Compares orientation estimators on the same poses. Connect a device that measures the field of a rotor in space, or play a recording of one.</source>
        <translation>Vergleicht Schätzer der Orientierung an denselben Lagen. Ein Gerät verbinden, das das Feld eines Rotors im Raum misst, oder eine Aufzeichnung davon abspielen.</translation>
    </message>
    <message>
        <source>Sensors at %1 (%4), %2 mm from the centre; q %3 mT</source>
        <translation>Sensoren bei %1 (%4), %2 mm vom Mittelpunkt; q %3 mT</translation>
    </message>
    <message>
        <source>Rows of the last 10 seconds</source>
        <translation>Zeilen der letzten 10 Sekunden</translation>
    </message>
    <message>
        <source>Random poses in the workspace, or rows, chosen evenly</source>
        <translation>Zufällige Lagen im Arbeitsbereich oder gleichmäßig gewählte Zeilen</translation>
    </message>
    <message>
        <source>The rows have no true angles (truth.alpha, truth.beta, truth.gamma): errors are differences from the projector with a Gauss-Newton step.</source>
        <translation>Die Zeilen haben keine wahren Winkel (truth.alpha, truth.beta, truth.gamma): Fehler sind Abweichungen vom Projektor mit Gauß-Newton-Schritt.</translation>
    </message>
</context>
<context>
    <name>halbench::app::CoveragePanel</name>
    <message>
        <source>Sensors of the map</source>
        <translation>Sensoren der Karte</translation>
    </message>
    <message>
        <source>Click or arrow keys read a pose; Home goes to the middle</source>
        <translation>Klick oder Pfeiltasten lesen eine Lage ab; Pos1: Mitte</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Quantity that the colours show</source>
        <translation>Größe, die die Farben zeigen</translation>
    </message>
    <message>
        <source>Least reading</source>
        <translation>Kleinster Messwert</translation>
    </message>
    <message>
        <source>Predicted angle error</source>
        <translation>Vorhergesagter Winkelfehler</translation>
    </message>
    <message>
        <source>Readings from</source>
        <translation>Messwerte aus</translation>
    </message>
    <message>
        <source>Model that makes the readings of the sensors</source>
        <translation>Modell, das die Messwerte der Sensoren liefert</translation>
    </message>
    <message>
        <source>Physical field</source>
        <translation>Physikalisches Feld</translation>
    </message>
    <message>
        <source>Additive model</source>
        <translation>Additives Modell</translation>
    </message>
    <message>
        <source>Held angle</source>
        <translation>Fester Winkel</translation>
    </message>
    <message>
        <source>Angle of the slider; the map is over the other two</source>
        <translation>Winkel des Reglers; die Karte zeigt die anderen zwei</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Least reading of R, Θ and Φ in a covered pose</source>
        <translation>Kleinster Wert von R, Θ, Φ in einer abgedeckten Lage</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Noise of each reading, rms, for the predicted error</source>
        <translation>Rauschen je Messwert, effektiv, für die Vorhersage</translation>
    </message>
    <message>
        <source>Angle at which the map is cut</source>
        <translation>Winkel, bei dem die Karte geschnitten ist</translation>
    </message>
    <message>
        <source>Pose read from the map</source>
        <translation>Abgelesene Lage</translation>
    </message>
    <message>
        <source>Coverage of all poses</source>
        <translation>Abdeckung aller Lagen</translation>
    </message>
    <message>
        <source>Go to &amp;counterexample</source>
        <translation>Zum &amp;Gegenbeispiel</translation>
    </message>
    <message>
        <source>Show the slice of the uncovered pose (Alt+C)</source>
        <translation>Den Schnitt der nicht abgedeckten Lage zeigen (Alt+G)</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>Bild s&amp;peichern…</translation>
    </message>
    <message>
        <source>Save as SVG, PDF or PNG (Alt+P)</source>
        <translation>Als SVG, PDF oder PNG speichern (Alt+P)</translation>
    </message>
    <message>
        <source>Shows where field sensors about a rotor read enough. Connect a device with such sensors, or play a recording of one.</source>
        <translation>Zeigt, wo Feldsensoren um einen Rotor genug messen. Ein Gerät mit solchen Sensoren verbinden oder eine Aufzeichnung davon abspielen.</translation>
    </message>
    <message>
        <source>Slider for %1</source>
        <translation>Regler für %1</translation>
    </message>
    <message>
        <source>Arrow keys: half a degree; Page Up and Down: five</source>
        <translation>Pfeiltasten: ein halbes Grad; Bild auf/ab: fünf</translation>
    </message>
    <message>
        <source>%1 of %2 poses of this slice are not covered.</source>
        <translation>%1 von %2 Lagen dieses Schnitts sind nicht abgedeckt.</translation>
    </message>
    <message>
        <source>Proven: all poses of the workspace are covered.</source>
        <translation>Bewiesen: alle Lagen des Arbeitsbereichs sind abgedeckt.</translation>
    </message>
    <message>
        <source>Not covered: (%1, %2, %3)°, where %4 is at most %5 mT.</source>
        <translation>Nicht abgedeckt: (%1, %2, %3)°, dort ist %4 höchstens %5 mT.</translation>
    </message>
    <message>
        <source>On trial, not on the board. %1</source>
        <translation>Zur Probe, nicht auf dem Board. %1</translation>
    </message>
    <message>
        <source>Least reading %1 mT, conditioning %2, predicted error %3° rms</source>
        <translation>Kleinster Messwert %1 mT, Konditionszahl %2, vorhergesagter Fehler %3° (Effektivwert)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Figures of the placement</source>
        <translation>Kennzahlen der Anordnung</translation>
    </message>
    <message>
        <source>&amp;Board&apos;s placement</source>
        <translation>Anordnung des &amp;Boards</translation>
    </message>
    <message>
        <source>Show the sensors of the board again (Alt+B)</source>
        <translation>Wieder die Sensoren des Boards zeigen (Alt+B)</translation>
    </message>
    <message>
        <source>&amp;Recommended</source>
        <translation>&amp;Empfohlen</translation>
    </message>
    <message>
        <source>Try the placement that is proven to cover all (Alt+R)</source>
        <translation>Nachweislich lückenlose Anordnung probieren (Alt+E)</translation>
    </message>
    <message>
        <source>Poses are (α, β, γ): %1.</source>
        <translation>Lagen sind (α, β, γ): %1.</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::CoverageView</name>
    <message>
        <source>%1, not covered</source>
        <translation>%1, nicht abgedeckt</translation>
    </message>
    <message>
        <source>Map of the coverage over two angles</source>
        <translation>Karte der Abdeckung über zwei Winkel</translation>
    </message>
</context>
<context>
    <name>halbench::app::PlacementEditor</name>
    <message>
        <source>Drag a sensor, or 0, 1, 2 and arrow keys; Shift turns</source>
        <translation>Sensor ziehen oder 0, 1, 2 und Pfeiltasten; Umschalt dreht</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>Sensor that the angles and arrow keys move</source>
        <translation>Sensor, den die Winkel und die Pfeiltasten bewegen</translation>
    </message>
    <message>
        <source>Rotation from the X axis to the sensor&apos;s place</source>
        <translation>Drehung von der X-Achse zum Ort des Sensors</translation>
    </message>
    <message>
        <source>Order of the rotations</source>
        <translation>Reihenfolge der Drehungen</translation>
    </message>
</context>
<context>
    <name>halbench::app::SimulationOptionsDialog</name>
    <message>
        <source>Simulation options</source>
        <translation>Optionen der Simulation</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter by name or meaning</source>
        <translation>Nach Name oder Bedeutung filtern</translation>
    </message>
    <message>
        <source>Write the options into the address</source>
        <translation>Optionen in die Adresse schreiben</translation>
    </message>
    <message>
        <source>Standard values</source>
        <translation>Standardwerte</translation>
    </message>
    <message>
        <source>Remove all options</source>
        <translation>Alle Optionen entfernen</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>random</source>
        <translation>zufällig</translation>
    </message>
    <message>
        <source>Enter a value of the range, or leave the cell empty.</source>
        <translation>Einen Wert des Bereichs eingeben oder das Feld leer lassen.</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::HallTraceView</name>
    <message>
        <source>Hall A</source>
        <translation>Hall A</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>Hall B</translation>
    </message>
    <message>
        <source>Hall readings over a turn</source>
        <translation>Hall-Messwerte über eine Umdrehung</translation>
    </message>
    <message>
        <source>Hall B over Hall A, the newest reading at each angle</source>
        <translation>Hall B über Hall A, neuester Messwert je Winkel</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecentLists</name>
    <message>
        <source>moved or deleted</source>
        <translation>verschoben oder gelöscht</translation>
    </message>
    <message>
        <source>no permission to read it</source>
        <translation>keine Leseberechtigung</translation>
    </message>
    <message>
        <source>Enter opens, Delete removes from the list</source>
        <translation>Eingabe öffnet, Entf entfernt aus der Liste</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Zuletzt geöffnete Projekte</translation>
    </message>
    <message>
        <source>No recent projects. Ctrl+O opens one, Ctrl+S saves this one.</source>
        <translation>Keine zuletzt geöffneten Projekte. Strg+O öffnet eines, Strg+S speichert dieses.</translation>
    </message>
    <message>
        <source>Recent recordings</source>
        <translation>Letzte Aufzeichnungen</translation>
    </message>
    <message>
        <source>No recent recordings. Ctrl+R records a device.</source>
        <translation>Keine letzten Aufzeichnungen. Strg+R zeichnet ein Gerät auf.</translation>
    </message>
</context>
<context>
    <name>halbench::app::StartList</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Pfad kopieren</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>Aus der Liste entfernen</translation>
    </message>
</context>
<context>
    <name>halbench::app::SampleList</name>
    <message>
        <source>Sample recordings</source>
        <translation>Beispielaufzeichnungen</translation>
    </message>
    <message>
        <source>Enter or double-click opens a copy</source>
        <translation>Eingabetaste oder Doppelklick öffnet eine Kopie</translation>
    </message>
    <message>
        <source>Five-minute tour</source>
        <translation>Fünf-Minuten-Tour</translation>
    </message>
    <message>
        <source>Shows the steps from connecting to tuning (Shift+F1)</source>
        <translation>Zeigt die Schritte vom Verbinden bis zum Auslegen (Umschalt+F1)</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Motor: step of 30°</source>
        <translation>Motor: Sprung um 30°</translation>
    </message>
    <message>
        <source>Positioner: step of 100 µm along x</source>
        <translation>Positionierer: Sprung um 100 µm längs x</translation>
    </message>
    <message>
        <source>Sphere: turning, with its orientation</source>
        <translation>Kugel: Drehung mit ihrer Lage</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Connect a device</source>
        <translation>Gerät verbinden</translation>
    </message>
    <message>
        <source>Choose a simulated actuator and press Enter, or double-click it. A real device is listed when it is plugged in.</source>
        <translation>Einen simulierten Aktor wählen und die Eingabetaste drücken, oder doppelklicken. Ein wirkliches Gerät steht in der Liste, sobald es angesteckt ist.</translation>
    </message>
    <message>
        <source>Watch the signals</source>
        <translation>Signale beobachten</translation>
    </message>
    <message>
        <source>The plots follow the device. F6 lists all signals, Space pauses the view, the wheel zooms.</source>
        <translation>Die Diagramme folgen dem Gerät. F6 listet alle Signale, die Leertaste hält die Ansicht an, das Rad zoomt.</translation>
    </message>
    <message>
        <source>Arm and drive</source>
        <translation>Freigeben und bewegen</translation>
    </message>
    <message>
        <source>Arm, choose a reference, for example a sine, and start it. Esc or STOP stops the actuator at any time.</source>
        <translation>Freigeben, eine Führungsgröße wählen, zum Beispiel einen Sinus, und sie starten. Esc oder STOPP hält den Aktor jederzeit an.</translation>
    </message>
    <message>
        <source>Calibrate the sensors</source>
        <translation>Sensoren kalibrieren</translation>
    </message>
    <message>
        <source>A short motion measures the errors of the sensors; Apply corrects them. Simulated time 20 times shortens the wait.</source>
        <translation>Eine kurze Bewegung misst die Fehler der Sensoren; Übernehmen berichtigt sie. Simulierte Zeit 20-fach verkürzt das Warten.</translation>
    </message>
    <message>
        <source>Identify the actuator</source>
        <translation>Aktor identifizieren</translation>
    </message>
    <message>
        <source>Start identification measures the constants of the model, each with its 95 % interval, or says why it cannot.</source>
        <translation>„Identifikation starten“ misst die Konstanten des Modells, jede mit ihrem 95-%-Intervall, oder nennt den Grund, warum es nicht geht.</translation>
    </message>
    <message>
        <source>Tune the controller</source>
        <translation>Regler auslegen</translation>
    </message>
    <message>
        <source>Tune designs gains for the identified model. Apply and verify compares a test move with the prediction; Keep or Restore ends it.</source>
        <translation>„Auslegen“ entwirft Reglerparameter für das identifizierte Modell. „Übernehmen, prüfen“ vergleicht eine Prüfbewegung mit der Vorhersage; „Behalten“ oder „Zurücksetzen“ schließt es ab.</translation>
    </message>
    <message>
        <source>Record and compare</source>
        <translation>Aufzeichnen und vergleichen</translation>
    </message>
    <message>
        <source>Ctrl+R starts and ends a recording. The list of recordings opens, replays and overlays them.</source>
        <translation>Strg+R beginnt und beendet eine Aufzeichnung. Die Liste der Aufzeichnungen öffnet sie, gibt sie wieder und überlagert sie.</translation>
    </message>
    <message>
        <source>Find help</source>
        <translation>Hilfe finden</translation>
    </message>
    <message>
        <source>F1 explains the panel with the focus, Ctrl+F1 lists all keys. First steps and this tour are in the Help menu.</source>
        <translation>F1 erklärt den Bereich mit dem Fokus, Strg+F1 listet alle Tasten. Erste Schritte und diese Tour stehen im Menü Hilfe.</translation>
    </message>
</context>
<context>
    <name>halbench::app::Tour</name>
    <message>
        <source>Five-minute &amp;tour</source>
        <translation>Fünf-M&amp;inuten-Tour</translation>
    </message>
</context>
<context>
    <name>halbench::app::TourCard</name>
    <message>
        <source>Five-minute tour</source>
        <translation>Fünf-Minuten-Tour</translation>
    </message>
    <message>
        <source>Shift+F1 switches between tour and panel.</source>
        <translation>Umschalt+F1 wechselt zwischen Tour und Bereich.</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>Tour verlassen</translation>
    </message>
    <message>
        <source>Leave the tour (Esc)</source>
        <translation>Tour verlassen (Esc)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>Voriger Schritt (Links)</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>Nächster Schritt (Rechts)</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::PathForm</name>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Umläufe</translation>
    </message>
    <message>
        <source>Line length</source>
        <translation>Zeilenlänge</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Line spacing</source>
        <translation>Zeilenabstand</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Halt</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Raster</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Table of poses</source>
        <translation>Tabelle von Lagen</translation>
    </message>
    <message>
        <source>No file</source>
        <translation>Keine Datei</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>CSV with columns like time_s, x_mm, phi_mrad</source>
        <translation>CSV mit Spalten wie time_s, x_mm, phi_mrad</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>%1; 0: no limit</source>
        <translation>%1; 0: keine Grenze</translation>
    </message>
    <message>
        <source>No table of poses is chosen.</source>
        <translation>Keine Tabelle von Lagen gewählt.</translation>
    </message>
    <message>
        <source>Choose a CSV file.</source>
        <translation>Eine CSV-Datei wählen.</translation>
    </message>
    <message>
        <source>Travel time: %1 s</source>
        <translation>Fahrzeit: %1 s</translation>
    </message>
    <message>
        <source>Rotation speed</source>
        <translation>Drehgeschwindigk.</translation>
    </message>
    <message>
        <source>Rotation accel.</source>
        <translation>Drehbeschleunig.</translation>
    </message>
    <message>
        <source>Rotation jerk</source>
        <translation>Drehruck</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Ruck</translation>
    </message>
    <message>
        <source>File that the motion follows</source>
        <translation>Datei, der die Bewegung folgt</translation>
    </message>
</context>
<context>
    <name>halbench::app::PathRun</name>
    <message>
        <source>Choose a table of poses</source>
        <translation>Tabelle von Lagen wählen</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt)</source>
        <translation>Tabellen (*.csv *.txt)</translation>
    </message>
    <message>
        <source>Moves together: %1.</source>
        <translation>Bewegt gemeinsam: %1.</translation>
    </message>
    <message>
        <source>Above the limit: the device may stop.</source>
        <translation>Über dem Grenzwert: Das Gerät kann stoppen.</translation>
    </message>
</context>
<context>
    <name>halbench::app::AngleErrorPanel</name>
    <message>
        <source>Time span</source>
        <translation>Zeitspanne</translation>
    </message>
    <message>
        <source>Length of the data shown, up to now</source>
        <translation>Länge der gezeigten Daten, bis jetzt</translation>
    </message>
    <message>
        <source>Summary of the angle error</source>
        <translation>Zusammenfassung des Winkelfehlers</translation>
    </message>
    <message>
        <source>Shows the angle between the estimated and the true orientation of a simulated rotor. Connect a simulated device that measures its field, or play a recording with truth.alpha, truth.beta and truth.gamma.</source>
        <translation>Zeigt den Winkel zwischen geschätzter und wahrer Orientierung eines simulierten Rotors. Verbinden Sie ein simuliertes Gerät, das sein Feld misst, oder spielen Sie eine Aufzeichnung mit truth.alpha, truth.beta und truth.gamma ab.</translation>
    </message>
    <message>
        <source>Angle between the estimated and the true orientation</source>
        <translation>Winkel zwischen geschätzter und wahrer Orientierung</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>angle error</source>
        <translation>Winkelfehler</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>shaft</source>
        <translation>Welle</translation>
    </message>
    <message>
        <source>95 % cone of the shaft</source>
        <translation>95-%-Kegel der Welle</translation>
    </message>
    <message>
        <source>%1 rows: %2° rms, %3° at most, to the nearest of the four orientations with the same field.</source>
        <translation>%1 Zeilen: %2° Effektivwert, höchstens %3°, zur nächsten der vier Orientierungen mit demselben Feld.</translation>
    </message>
    <message>
        <source>Arrow keys read values; Ctrl+C copies, Ctrl+E saves</source>
        <translation>Pfeiltasten lesen Werte; Strg+C kopiert, Strg+E speichert</translation>
    </message>
</context>
</TS>
