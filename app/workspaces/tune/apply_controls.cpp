#include "app/workspaces/tune/apply_controls.h"

#include "app/procedures/apply/live_apply_procedure.h"
#include "app/workspaces/parts/foreign_motor_notice.h"
#include "app/workspaces/parts/preflight.h"
#include "app/workspaces/tune/gain_decision.h"
#include "app/workspaces/tune/tune_numbers.h"
#include "app/workspaces/tune/tune_session.h"
#include "widgets/controls/progress_row.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace halbench::app {
namespace {

void say(QAbstractButton& button, const QString& text, const QString& help) {
    button.setText(text);
    button.setToolTip(help);
    button.setAccessibleName(text);
}

} // namespace

ApplyControls::ApplyControls(Workbench& bench, const TuneSession& session, GainDecision& decision,
                             Preflight& preflight, ForeignMotorNotice& foreign, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_session(session), m_decision(decision), m_preflight(preflight),
      m_foreign(foreign), m_progress(new widgets::ProgressRow(this)), m_gradually(new QCheckBox(this)),
      m_outlook(new QLabel(this)) {
    m_progress->hide();
    m_outlook->setWordWrap(true);
    buildButtons();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::PanelMargin_px);
    column->addWidget(m_gradually, 0, Qt::AlignLeft);
    column->addWidget(m_outlook);
    column->addWidget(m_progress);
    column->addLayout(m_buttons);
    connectParts();
}

/// Keep and Restore have their places while they are hidden too: were Apply and verify to move there when
/// they go, the second click of a double click on Keep would start another motion.
void ApplyControls::buildButtons() {
    m_apply = new QPushButton(this);
    m_keep = new QPushButton(this);
    m_restore = new QPushButton(this);
    for (QPushButton* button : {m_keep, m_restore}) {
        QSizePolicy policy = button->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        button->setSizePolicy(policy);
    }
    widgets::setRole(*m_apply, widgets::Role::Primary);
    m_restore->setIcon(widgets::themedIcon(QStringLiteral("revert")));
    m_buttons = new QGridLayout;
    m_buttons->setSpacing(widgets::PanelMargin_px);
    m_buttons->addWidget(m_apply, 0, 0);
    m_buttons->addWidget(m_keep, 1, 0);
    m_buttons->addWidget(m_restore, 1, 1, 1, 2, Qt::AlignLeft);
    m_buttons->setColumnStretch(2, 1);
}

void ApplyControls::addTool(QWidget& tool) {
    m_buttons->addWidget(&tool, 0, 1);
}

void ApplyControls::connectParts() {
    connect(&m_preflight, &Preflight::changed, this, &ApplyControls::refresh);
    connect(&m_foreign, &ForeignMotorNotice::changed, this, &ApplyControls::refresh);
    connect(&m_decision, &GainDecision::changed, this, &ApplyControls::showRunning);
    connect(m_apply, &QPushButton::clicked, this, &ApplyControls::apply);
    connect(m_keep, &QPushButton::clicked, &m_decision, &GainDecision::keep);
    connect(m_restore, &QPushButton::clicked, &m_decision, &GainDecision::restore);
    connect(m_gradually, &QCheckBox::toggled, this, [this] {
        refreshOutlook();
        refresh();
    });
    DeviceSession& session = m_bench.session();
    connect(m_progress, &widgets::ProgressRow::cancelRequested, &session, &DeviceSession::abortProcedure);
    connect(&session, &DeviceSession::procedureChanged, this, &ApplyControls::refresh);
    connect(&session, &DeviceSession::reportChanged, this, &ApplyControls::refresh); // armed?
    connect(&session, &DeviceSession::procedureProgress, this, [this](double fraction, const QString& text) {
        if (m_decision.isApplying()) {
            m_progress->setText(tr("Verification: %1").arg(widgets::inWords(text)));
            m_progress->setProgress(fraction);
        }
    });
}

void ApplyControls::apply() {
    m_preflight.setRunning(tr("Verification running"));
    m_decision.apply(m_gradually->isChecked());
    m_progress->setText(tr("Writing the gains"));
    m_progress->setProgress(0.0);
    showRunning();
    if (m_decision.isApplying()) {
        m_progress->setFocus(Qt::OtherFocusReason);
    }
}

void ApplyControls::showRunning() {
    if (!m_decision.isApplying()) {
        m_preflight.setRunning({});
    }
    m_progress->setVisible(m_decision.isApplying());
    refresh();
}

void ApplyControls::refresh() {
    const auto& proposed = m_session.proposed();
    const bool hasObstacle = m_session.obstacle(m_gradually->isChecked()).has_value();
    const bool isUsable = proposed && proposed->quality.verdict != Verdict::Refused && !hasObstacle;
    m_apply->setEnabled(isUsable && m_preflight.isPassed() && m_foreign.isAllowed() &&
                        !m_decision.isApplying());
    if (hasObstacle != m_isObstacleShown) {
        refreshOutlook();
    }
    m_keep->setVisible(m_decision.isUndecided());
    m_restore->setVisible(m_decision.isUndecided());
    const DeviceSession& session = m_bench.session();
    const bool isFree = session.state() == SessionState::Connected && session.procedure().isEmpty();
    m_keep->setEnabled(isFree && !m_decision.isLooking());
    m_restore->setEnabled(isFree && !session.report().board.isArmed); // a loop that runs would jump
}

void ApplyControls::refreshOutlook() {
    const auto obstacle = m_session.obstacle(m_gradually->isChecked());
    m_isObstacleShown = obstacle.has_value();
    if (obstacle) {
        m_outlook->setToolTip(widgets::inWords(obstacle->hint));
        m_outlook->setText(tr("These gains cannot be applied: %1. %2.")
                               .arg(widgets::inWords(obstacle->message), widgets::inWords(obstacle->hint)));
        return;
    }
    m_outlook->setToolTip(tr("Relative to the start position of the rotor"));
    const devices::Catalogue& catalogue = m_bench.session().catalogue();
    const DisplayUnits& units = m_bench.displayUnits();
    m_outlook->setText(m_gradually->isChecked()
                           ? liveStepWords(liveStepOutlook({}, catalogue), units)
                           : verificationWords(verificationOutlook(stepVerification({}), catalogue), units));
}

void ApplyControls::refreshTexts() {
    say(*m_apply, tr("Apply and verify"),
        tr("Write all gains together, then verify with a step; Esc stops it"));
    m_gradually->setText(tr("Apply gradually"));
    m_gradually->setToolTip(
        tr("Change K_P and K_P + K_D/T by at most half in each step. Each step is assessed before writing "
           "and verified by a move; on failure the previous gains are restored"));
    m_gradually->setAccessibleName(m_gradually->text());
    say(*m_keep, tr("Keep"),
        tr("New gains active until power-off (simulated: until disconnect). To keep them: Save to device, in "
           "the Parameters panel"));
    say(*m_restore, tr("Restore"), tr("Restore the previous gains"));
    refreshOutlook();
}

void ApplyControls::focusKeep() {
    m_keep->setFocus(Qt::OtherFocusReason);
}

} // namespace halbench::app
