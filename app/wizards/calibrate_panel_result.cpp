#include "app/figures/calibration_figures.h"
#include "app/wizards/calibrate_panel.h"
#include "app/wizards/calibrate_text.h"
#include "app/wizards/identify_text.h"
#include "app/wizards/note_label.h"
#include "app/wizards/words_and_pictures.h"
#include "app/workspaces/parts/quality_view.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/step_list.h"
#include "widgets/controls/verdict_view.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/display_units.h"

#include <QLabel>
#include <QTabWidget>

#include <algorithm>
#include <tuple>

namespace halbench::app {

std::optional<CalibrationRecord> CalibratePanel::record() const {
    return m_result ? std::optional(CalibrationRecord{m_header, *m_result}) : std::nullopt;
}

void CalibratePanel::restore(std::optional<CalibrationRecord> record) {
    if (isMine()) {
        return; // what runs now is shown when it ends
    }
    ++m_connection; // a write that is on its way was of another result
    messages().clear();
    m_result.reset();
    m_origin = Origin::Project;
    if (!record) {
        showPage(PreparePage);
        resetSteps();
        refreshPlan();
        return;
    }
    m_header = record->header;
    m_result = std::move(record->result);
    m_result->isApplied = false; // whether the device still has it is not known
    showResult();
    sayOrigin();
    runStep(ApplyStep);
    endStep(ApplyStep, widgets::StepState::Waiting);
    showPage(ResultPage);
}

/// A board without a name cannot be told from another one.
bool CalibratePanel::isOfThisDevice() const {
    const auto& measured = m_header.device;
    const bool isNamed = measured && !(measured->model + measured->id).empty();
    return m_origin == Origin::ThisConnection ||
           (isNamed && isSameDevice(*measured, bench().session().info()));
}

bool CalibratePanel::isOnDevice() const {
    return std::all_of(m_result->proposed.begin(), m_result->proposed.end(),
                       [this](const ParameterValue& proposed) {
                           const auto value = bench().deviceValue(proposed.name);
                           return value && widgets::areSameOnBoard(*value, proposed.value);
                       });
}

void CalibratePanel::apply() {
    // Restore brings back what the device has now, not what it had then.
    if (m_origin != Origin::ThisConnection) {
        m_result->before.clear();
        for (const ParameterValue& proposed : m_result->proposed) {
            if (const auto value = bench().deviceValue(proposed.name)) {
                m_result->before.push_back({proposed.name, *value});
            }
        }
    }
    write(m_result->proposed, true);
}

void CalibratePanel::showResult() {
    m_verdict->setVerdict(verdictLevel(m_result->quality.verdict), verdictTitle(m_result->quality),
                          remarksOf(m_result->quality.findings));
    m_table->setAccessibleName(tr("Calibrated values"));
    showRows();
    showNote(*m_friction, breakawayNote(*m_result));
    m_provenance->setText(provenanceText(m_header, m_result->duration_s, std::nullopt));
    m_gain->setText(calibrationGain(*m_result, bench().displayUnits()));
    m_gain->setVisible(!m_gain->text().isEmpty());
    showFigures();
    m_both->setWordsName(tr("Calibrated values"));
    m_both->shareAnew();
    refreshPlan();
}

void CalibratePanel::showFigures() {
    const widgets::AngleUnit unit = bench().displayUnits().angle;
    std::optional<widgets::Figure> friction;
    if (!m_result->staticFriction.empty()) {
        friction = staticFrictionFigure(m_result->staticFriction, unit);
    }
    const std::tuple<std::optional<widgets::Figure>, QString, QString> pictures[] = {
        {hallEllipseFigure(*m_result), tr("Hall ellipse"), tr("Hall sensor readings and the fitted ellipse")},
        {hallResidualFigure(*m_result, unit), tr("Residual"),
         tr("Distance of the readings from the ellipse over the angle")},
        {friction, tr("Static friction"), tr("Breakaway current over the angle, both directions")}};
    bool isAny = false;
    for (int i = 0; i < m_figures->count(); ++i) {
        const auto& [figure, title, help] = pictures[i];
        m_views[static_cast<std::size_t>(i)]->setFigure(figure.value_or(widgets::Figure{}));
        m_figures->setTabText(i, title);
        m_figures->setTabToolTip(i, help);
        m_figures->setTabVisible(i, figure.has_value());
        isAny = isAny || figure.has_value();
    }
    m_figures->setAccessibleName(tr("Pictures of the calibration"));
    m_figures->setVisible(isAny);
}

/// Beside each value the one that the device has now, whoever wrote it.
void CalibratePanel::showRows() {
    if (m_result) {
        const bool isKnown = bench().session().state() == SessionState::Connected && isOfThisDevice();
        m_table->setLastTitle(isKnown ? tr("On the device") : tr("Before"));
        m_table->setRows(
            calibrationRows(*m_result, isKnown ? &bench().deviceValues() : nullptr, bench().displayUnits()));
    }
}

void CalibratePanel::onValues() {
    showRows();
    if (m_result && m_origin != Origin::ThisConnection && messages().message().text == m_saidOfOrigin) {
        sayOrigin(); // whether the device has it is known now
    }
}

/// Measured a connection ago or come with a project: whose it is, and whether that device has it.
void CalibratePanel::sayOrigin() {
    const DeviceSession& session = bench().session();
    const bool isConnected = session.state() == SessionState::Connected;
    const QString origin =
        m_origin == Origin::Project ? projectCalibrationText(m_header) : earlierCalibrationText(m_header);
    const bool isUsable = !m_result->proposed.empty() && m_result->quality.verdict != Verdict::Refused;
    QString next =
        tr("Valid only for the device it was measured on. Calibrate again after any work on the sensors.");
    if (isConnected && isUsable && isOfThisDevice()) {
        next = isOnDevice() ? tr("These values are on the device.")
                            : tr("Not on the device yet: press Apply to write the values. Calibrate again "
                                 "after any work on the sensors.");
    }
    m_saidOfOrigin =
        origin + QLatin1Char(' ') + projectDeviceText(m_header, isConnected ? &session.info() : nullptr);
    messages().showMessage({widgets::Severity::Information, m_saidOfOrigin, next, {}});
}

void CalibratePanel::write(const std::vector<ParameterValue>& values, bool isApplying) {
    const QPointer<CalibratePanel> self(this);
    bench().writeValues(values, [self, isApplying, connection = m_connection](const Result<void>& written) {
        if (!self || connection != self->m_connection || !self->m_result) {
            return;
        }
        if (!written) {
            self->showError(written.error());
            return;
        }
        self->m_result->isApplied = isApplying;
        self->endStep(ApplyStep, isApplying ? widgets::StepState::Done : widgets::StepState::Waiting);
        const bool isSimulated = self->bench().session().info().isSimulated;
        const QString done =
            !isApplying   ? tr("Previous values restored.")
            : isSimulated ? tr("Applied and read back. Lost when the simulated device is disconnected.")
                          : tr("Applied and read back. Lost at power-off.");
        self->bench().session().message(MessageLevel::Info, tr("Calibrate"), done);
        const bool leadsOn = isApplying && self->bench().session().catalogue().hasProcedure("identify");
        self->messages().showMessage(
            {widgets::Severity::Success, done, {}, leadsOn ? tr("Identify next") : QString()});
        self->refreshPlan();
        if (self->m_origin == Origin::ThisConnection) {
            self->calibrated();
        }
    });
}

} // namespace halbench::app
