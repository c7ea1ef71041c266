#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace halbench::app {

/// A recording that comes with the program, of a simulated actuator, as :/samples/FILE.csv with its sidecar.
struct SampleRecording {
    QString file;   ///< without folder and ending
    QString title;  ///< in the user's language
    QString device; ///< address of the actuator that made it
    /// Arguments of the command line that made it, but for --out: the same again give the same bytes.
    QStringList command;
};

/// One or more of each kind of actuator, in the order of lists.
std::vector<SampleRecording> sampleRecordings();

} // namespace halbench::app
