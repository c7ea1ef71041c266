#include "app/wizards/excitation_panel.h"

#include "app/procedures/base/coil_forecast.h"
#include "app/workspaces/parts/preflight.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/controls/step_list.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace halbench::app {
namespace {

constexpr double AssumedStart_degC = 25.0;

} // namespace

ExcitationPanel::ExcitationPanel(Workbench& workbench, QWidget* parent)
    : WizardPanel(workbench, parent), m_intro(new QLabel), m_outlook(new QLabel),
      m_preflight(new Preflight(bench())), m_start(new QPushButton(this)), m_use(new QPushButton(this)),
      m_again(new QPushButton(this)) {}

void ExcitationPanel::addPages(QWidget& form, QWidget& result,
                               const std::vector<QPushButton*>& resultButtons) {
    addPage(makePreparation(*m_intro, form, *m_outlook, *m_preflight), true, makeStartRow(*m_start));
    QWidget* run = buildRun();
    addPage(run, false, m_progress);
    std::vector<QPushButton*> row = {m_use};
    row.insert(row.end(), resultButtons.begin(), resultButtons.end());
    row.push_back(m_again);
    addPage(&result, false, makeButtonRow(row));
    widgets::setRole(*m_use, widgets::Role::Primary);
    connect(m_start, &QPushButton::clicked, this, [this] { start(); });
    connect(m_again, &QPushButton::clicked, this, [this] { beginAgain(PreparePage, *m_start); });
    connect(m_preflight, &Preflight::changed, this, [this] { refreshPlan(); });
    connect(&bench(), &Workbench::deviceChanged, this, &ExcitationPanel::onDevice);
    connect(&bench(), &Workbench::valuesChanged, this, [this] { refreshPlan(); });
    connect(&bench().session(), &DeviceSession::procedureStage, this, &ExcitationPanel::onStage);
    connect(&bench().session(), &DeviceSession::procedureProgress, this, &ExcitationPanel::onProgress);
}

QWidget* ExcitationPanel::buildRun() {
    auto* page = new QWidget;
    auto* column = columnOf(page, widgets::PanelMargin_px);
    m_progress = new widgets::ProgressRow(page);
    m_running = new QLabel(page);
    m_running->setWordWrap(true);
    column->addWidget(m_running);
    column->addStretch(1);
    connect(m_progress, &widgets::ProgressRow::cancelRequested, this, [this] {
        m_isCancelling = true;
        bench().session().abortProcedure();
    });
    return page;
}

void ExcitationPanel::onDevice() {
    if (!isDepartureTold() && bench().session().state() == SessionState::Connected) {
        messages().clear();
    }
    refreshPlan();
}

void ExcitationPanel::refreshPlan() {
    m_isPlanOld = !isVisible();
    if (!m_isPlanOld) {
        makePlan();
    }
}

void ExcitationPanel::showEvent(QShowEvent* event) {
    WizardPanel::showEvent(event);
    if (m_isPlanOld) {
        refreshPlan();
    }
}

void ExcitationPanel::refuse(const Error& error) {
    m_outlook->setText(widgets::inWords(error.message) + QStringLiteral(" \u2192 ") +
                       widgets::inWords(error.hint));
    widgets::setRole(*m_outlook, widgets::Role::Bad);
    m_start->setEnabled(false);
}

void ExcitationPanel::promise(double meanSquare_A2, double duration_s,
                              const std::function<QString(double warmest_degC)>& words) {
    const DeviceSession& session = bench().session();
    const models::CoilHeatingConfig coil =
        coilModel(session.state() == SessionState::Connected ? session.catalogue() : devices::Catalogue{});
    const auto warmest_degC = [coil, meanSquare_A2, duration_s](double start_degC) {
        return forecastCoil_degC(coil, {start_degC, start_degC}, meanSquare_A2, duration_s);
    };
    announce(words(warmest_degC(m_preflight->temperature_degC().value_or(AssumedStart_degC))), warmest_degC);
}

void ExcitationPanel::announce(const QString& words, std::function<double(double start_degC)> warmest_degC) {
    widgets::setRole(*m_outlook, widgets::Role::None);
    m_outlook->setText(words);
    m_preflight->setForecast(std::move(warmest_degC));
    m_start->setEnabled(m_preflight->isPassed());
}

bool ExcitationPanel::isReady() const {
    return m_start->isEnabled() && m_preflight->isPassed();
}

void ExcitationPanel::showRunning(const QString& words) {
    m_isCancelling = false;
    m_progress->setText(words);
    m_progress->setProgress(0.0);
    runStep(PrepareStep);
    showPage(RunPage);
    m_progress->setFocus(Qt::OtherFocusReason);
    m_sinceStart.start();
}

void ExcitationPanel::onStage(ProcedureState stage) {
    if (!isMine()) {
        return;
    }
    if (stage == ProcedureState::Excite || stage == ProcedureState::Record) {
        runStep(ExciteStep);
    } else if (stage == ProcedureState::Fit || stage == ProcedureState::Judge) {
        runStep(FitStep);
        m_progress->setText(m_computing);
    }
}

void ExcitationPanel::onProgress(double fraction, const QString& text) {
    if (!isMine() || m_isCancelling) {
        return;
    }
    constexpr double Telling = 0.02; // before that the rest of the time is a guess
    const double done = std::clamp(fraction, 0.0, 0.99);
    const double wall_s = 1e-3 * static_cast<double>(m_sinceStart.elapsed());
    m_progress->setText(widgets::inWords(text));
    m_progress->setProgress(done,
                            done > Telling ? std::optional(wall_s * (1.0 - done) / done) : std::nullopt);
}

void ExcitationPanel::showFailure(const Error& error, const QString& cancelledText) {
    fail(error, cancelledText);
    refreshPlan();
    m_start->setFocus(Qt::OtherFocusReason);
}

void ExcitationPanel::showFound(bool isUsable) {
    m_use->setEnabled(isUsable);
    runStep(ResultStep);
    endStep(ResultStep, isUsable ? widgets::StepState::Done : widgets::StepState::Failed);
    showPage(ResultPage);
    (isUsable ? m_use : m_again)->setFocus(Qt::OtherFocusReason);
}

} // namespace halbench::app
