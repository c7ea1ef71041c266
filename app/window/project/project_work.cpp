#include "app/window/project/project_work.h"

#include "app/documents/filtered_gains.h"
#include "app/documents/identification_file.h"
#include "app/documents/result_documents.h"
#include "app/wizards/calibrate_panel.h"
#include "app/wizards/identify_panel.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/tune_panel.h"
#include "control/base/assert.h"
#include "widgets/language/phrasebook.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace halbench::app {

namespace {

std::string textOf(const JsonValue& document) {
    const Result<std::string> text = toJsonText(document);
    HB_ASSERT(text.has_value()); // a result holds finite numbers only
    return *text;
}

bool hasName(const std::vector<NamedDocument>& list, const std::string& name) {
    return std::any_of(list.begin(), list.end(),
                       [&](const NamedDocument& entry) { return entry.name == name; });
}

/// "htm 1", "htm 2" ...
std::string freeName(const std::vector<NamedDocument>& list, const std::string& stem) {
    for (std::size_t number = 1;; ++number) {
        const std::string name = fmt::format("{} {}", stem, number);
        if (!hasName(list, name)) {
            return name;
        }
    }
}

/// To the end of the list, where the one in use is; under its old name if it is there already.
void use(std::vector<NamedDocument>& list, std::string document, const std::string& stem) {
    const auto same = std::find_if(list.begin(), list.end(),
                                   [&](const NamedDocument& entry) { return entry.document == document; });
    if (same != list.end()) {
        std::rotate(same, same + 1, list.end());
    } else {
        list.push_back({freeName(list, stem), std::move(document)});
    }
}

QString complaint(const QString& what, const Error& error) {
    return what + QStringLiteral(": ") + widgets::inWords(error.message);
}

} // namespace

ProjectWork::ProjectWork(Workbench& bench, Panels panels, QObject* parent)
    : QObject(parent), m_bench(bench), m_panels(panels) {
    connect(&m_panels.calibrate, &CalibratePanel::calibrated, this, &ProjectWork::takeCalibration);
    connect(&m_bench, &Workbench::identificationChanged, this, &ProjectWork::takeIdentification);
    connect(&m_bench, &Workbench::designChanged, this, &ProjectWork::takeDesign);
    connect(&m_bench.recording(), &RecordingControl::changed, this, &ProjectWork::settleRecording);
}

void ProjectWork::fill(Project& project) const {
    project.models = m_models;
    project.designs.clear();
    for (const KeptDesign& design : m_panels.tune.savedDesigns()) {
        project.designs.push_back({design.name, design.document});
    }
    if (m_designInUse) {
        project.designs.push_back(*m_designInUse);
    }
    project.calibrations = m_calibrations;
    project.given = m_panels.identify.given();
    project.recording = m_recording.value_or(m_bench.recording().choice());
}

void ProjectWork::takeIdentification() {
    const auto& result = m_bench.identification();
    const Provenance& provenance = m_bench.provenance();
    if (!result || provenance.origin == ResultOrigin::Project ||
        result->quality.verdict == Verdict::Refused) {
        return;
    }
    ResultHeader header = provenance.header;
    header.schema = "halbench.identification/1";
    use(m_models, textOf(identificationDocument(header, *result)),
        header.device ? header.device->model : "motor");
}

void ProjectWork::takeDesign() {
    if (!m_bench.design() || m_bench.isDesignFromProject()) {
        return; // as the project has it, to the byte
    }
    if (m_designInUse && m_designInUse->name != DesignInUse) {
        m_panels.tune.adoptDesign(m_designInUse->name, m_designInUse->document); // it has a name of its own
    }
    m_designInUse = {DesignInUse, textOf(gainsDocument(m_bench.designHeader(), *m_bench.design()))};
}

/// The same calibration applied or taken back stays one entry.
void ProjectWork::takeCalibration() {
    const CalibrationRecord record = *m_panels.calibrate.record();
    CalibrateResult before = record.result;
    before.isApplied = !before.isApplied;
    const std::string replaced = textOf(calibrationDocument(record.header, before));
    const std::string document = textOf(calibrationDocument(record.header, record.result));
    for (NamedDocument& entry : m_calibrations) {
        entry.document = entry.document == replaced ? document : entry.document;
    }
    use(m_calibrations, document, record.header.device ? record.header.device->model : "motor");
}

QStringList ProjectWork::restore(const Project& project) {
    m_models = project.models;
    m_calibrations = project.calibrations;
    m_panels.identify.setGiven(project.given);
    m_recording = project.recording;
    settleRecording();
    QStringList complaints = {restoreModel(), restoreDesign(project.designs), restoreCalibration()};
    complaints.removeAll({});
    return complaints;
}

/// A recording ends by what it was begun with.
void ProjectWork::settleRecording() {
    RecordingControl& recording = m_bench.recording();
    if (m_recording == recording.choice()) {
        m_recording.reset();
    } else if (m_recording && !recording.isRecording() && !recording.isWaiting()) {
        const RecordingChoice choice = *std::exchange(m_recording, std::nullopt);
        recording.setChoice(choice);
    }
}

QString ProjectWork::restoreModel() {
    if (m_models.empty()) {
        m_bench.setIdentification(std::nullopt);
        return {};
    }
    const NamedDocument& last = m_models.back();
    const Result<IdentificationFile> model = parseIdentification(last.document, last.name);
    if (!model) {
        m_bench.setIdentification(std::nullopt);
        return complaint(tr("model"), model.error());
    }
    m_bench.setIdentification(model->result, {model->header, ResultOrigin::Project});
    return {};
}

QString ProjectWork::restoreDesign(const std::vector<NamedDocument>& designs) {
    // Files from before there were names have the one in use at their end, whatever it is called.
    const auto named = std::find_if(designs.begin(), designs.end(),
                                    [](const NamedDocument& one) { return one.name == DesignInUse; });
    const auto inUse = named != designs.end() || designs.empty() ? named : std::prev(designs.end());
    m_designInUse = inUse == designs.end() ? std::nullopt : std::optional(*inUse);
    std::vector<KeptDesign> kept;
    for (auto one = designs.begin(); one != designs.end(); ++one) {
        if (one != inUse) {
            kept.push_back(keptDesign(one->name, one->document));
        }
    }
    m_panels.tune.setSavedDesigns(std::move(kept));
    if (!m_designInUse) {
        m_panels.tune.restoreDesign(std::nullopt);
        return {};
    }
    Result<GainsFile> gains = parseFilteredGains(m_designInUse->document, m_designInUse->name);
    if (!gains) {
        // Beside what is designed in its place, which would be written over it.
        m_panels.tune.adoptDesign(m_designInUse->name, m_designInUse->document);
        m_designInUse.reset();
        m_panels.tune.restoreDesign(std::nullopt);
        return complaint(tr("gains"), gains.error());
    }
    m_panels.tune.restoreDesign(*std::move(gains));
    return {};
}

QString ProjectWork::restoreCalibration() {
    if (m_calibrations.empty()) {
        m_panels.calibrate.restore(std::nullopt);
        return {};
    }
    const NamedDocument& last = m_calibrations.back();
    Result<CalibrationRecord> record = parseCalibrationRecord(last.document, last.name);
    if (!record) {
        m_panels.calibrate.restore(std::nullopt);
        return complaint(tr("calibration"), record.error());
    }
    m_panels.calibrate.restore(*std::move(record));
    return {};
}

} // namespace halbench::app
