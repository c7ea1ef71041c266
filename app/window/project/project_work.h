#pragma once

#include "app/window/project/project_file.h"
#include "app/workbench/workbench.h"

#include <QObject>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

class CalibratePanel;
class IdentifyPanel;
class TunePanel;

/// The results of the work in a project: what was identified and designed goes in as it comes up, what a
/// project holds comes back to where it is used. Of each list the last entry is the one in use; a document
/// that cannot be read stays in the project as it is (resources/help/projects.md). With it comes when the
/// Record panel's recordings begin and end: once what is recorded while it comes has ended. Thread: GUI.
class ProjectWork : public QObject {
    Q_OBJECT

public:
    /// Where a project's work is shown and made.
    struct Panels {
        IdentifyPanel& identify;
        CalibratePanel& calibrate;
        TunePanel& tune;
    };

    ProjectWork(Workbench& bench, Panels panels, QObject* parent);

    void fill(Project& project) const;
    /// Says what could not be brought back, and why; empty when all was.
    QStringList restore(const Project& project);
    /// Something is being recorded: what the project says of recordings holds after it.
    bool isRecordingOwed() const { return m_recording.has_value(); }

private:
    void takeIdentification();
    void takeDesign();
    void takeCalibration();
    void settleRecording();
    QString restoreModel();
    QString restoreDesign(const std::vector<NamedDocument>& designs);
    QString restoreCalibration();

    Workbench& m_bench;
    Panels m_panels;
    std::vector<NamedDocument> m_models;
    std::optional<NamedDocument> m_designInUse; ///< the others are the Tune panel's
    std::vector<NamedDocument> m_calibrations;
    std::optional<RecordingChoice> m_recording; ///< for after the present one
};

} // namespace halbench::app
