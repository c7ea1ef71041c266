#include "app/workspaces/drive/drive_panel.h"

#include "app/workbench/drive_words.h"
#include "app/workbench/fault_words.h"
#include "app/workspaces/drive/drive_limits.h"
#include "app/workspaces/drive/jog_row.h"
#include "app/workspaces/drive/reference_form.h"
#include "app/workspaces/parts/panel_parts.h"
#include "control/base/units.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

namespace halbench::app {

namespace {

using devices::BoardMode;
constexpr int LivePeriod_ms = 100;
constexpr int LeastState = 8; ///< characters of the state; the rest in its tooltip

/// What the drive shows of the device, whatever the plots show.
std::vector<std::string> shownSignals() {
    return {"position",           "speed",
            "reference",          "current_command",
            "coil_temperature.a", "coil_temperature.b",
            "reference.running"};
}

} // namespace

DrivePanel::DrivePanel(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_control(bench.drive()), m_shownMode(m_control.mode()),
      m_state(new widgets::ElidedLabel(LeastState, this)), m_rest(*m_state) {
    QVBoxLayout* column = makeScrollingColumn(this);
    m_message = new widgets::MessageBar(this);
    buildArm(column);
    buildSetpoint(column);
    buildReference(column);
    buildLimits(column);
    column->addStretch(1);
    layout()->addWidget(m_message); // at the end, so that nothing moves away from under the mouse
    connect(m_message, &widgets::MessageBar::actionTriggered, this, &DrivePanel::onMessageAction);
    connect(m_message, &widgets::MessageBar::dismissed, this, [this] {
        if (m_asking == Asking::NothingToDrive) {
            return; // said once for this device
        }
        if (std::exchange(m_asking, Asking::Nothing) == Asking::Consent) {
            m_control.dismissConsent();
        }
    });
    connect(&m_control, &DriveControl::consentSettled, this, &DrivePanel::endQuestion);
    connect(&m_control, &DriveControl::changed, this, &DrivePanel::refresh);
    connect(&m_control, &DriveControl::failed, this, &DrivePanel::showError);
    connect(&m_bench, &Workbench::valuesChanged, this, &DrivePanel::describeMotion);
    connect(&m_frame, &QTimer::timeout, this, &DrivePanel::refreshLive);
    m_frame.start(LivePeriod_ms);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &DrivePanel::onUnits);
    m_bench.liveSignals().want(this, shownSignals());
    onUnits();
    refreshUnits();
    refresh();
}

/// A field that loses the focus while the panel is destroyed has nobody left to tell.
DrivePanel::~DrivePanel() {
    for (widgets::QuantityEdit* field : findChildren<widgets::QuantityEdit*>()) {
        field->disconnect(this);
    }
}

void DrivePanel::onMessageAction() {
    const Asking asked = m_asking;
    m_asking = Asking::Nothing;
    m_message->clear();
    if (asked == Asking::Consent) {
        m_control.giveConsent();
        m_control.arm();
    } else if (asked == Asking::Release) {
        m_control.releaseStop();
    }
}

/// Answered here or at another place that asked.
void DrivePanel::endQuestion() {
    if (m_asking == Asking::Consent) {
        m_asking = Asking::Nothing;
        m_message->clear();
    }
}

void DrivePanel::onSetpoint() {
    if (!m_go->isEnabled()) {
        return;
    }
    if (!m_setpoint->hasAcceptableInput()) { // Go without leaving the field
        onSetpointRefused(m_setpoint->text());
        return;
    }
    m_setpoint->interpretText();
    const double wanted = m_setpoint->value() / factor();
    const auto range_rad = m_control.setpointRange_rad();
    if (range_rad && (wanted < range_rad->first || wanted > range_rad->second)) {
        showError(tr("%1 is beyond the excursion window, nothing was sent.").arg(valueText(wanted)),
                  tr("From %1 to %2 now. Widen the window on purpose, or disarm and arm to count anew.")
                      .arg(valueText(range_rad->first), valueText(range_rad->second)));
        return;
    }
    forgetError();
    m_control.setSetpoint(wanted, m_jog->speed_rad_s());
}

/// Nothing is sent; a field that was left shows what holds, so that a Go behind it moves nothing either.
void DrivePanel::onSetpointRefused(const QString& text) {
    if (!m_setpoint->hasFocus()) {
        m_setpoint->setValue(m_control.goal() * factor());
        m_isJustRefused = true; // a mouse on Go takes the focus first and presses then
        QTimer::singleShot(0, this, [this] { m_isJustRefused = false; });
    }
    showError(tr("'%1' is not a set-point, nothing was sent.").arg(text.trimmed()),
              m_setpoint->problemOf(text));
}

void DrivePanel::onStartReference() {
    const Result<std::vector<ParameterValue>> values = m_reference->takeValues();
    if (!values) {
        showError(widgets::inWords(values.error().message), widgets::inWords(values.error().hint));
        return;
    }
    forgetError();
    m_control.startReference(*values);
}

/// What was refused before is over when the next one is tried, or a good number stands there.
void DrivePanel::forgetError() {
    if (m_asking == Asking::Nothing) {
        m_message->clear();
    }
}

void DrivePanel::showError(const QString& text, const QString& remedy) {
    m_asking = Asking::Nothing;
    m_message->showMessage({widgets::Severity::Error, text, remedy, {}});
}

void DrivePanel::refresh() {
    refreshForeign();
    refreshStop();
    refreshState();
    refreshMode();
    if (!std::exchange(m_wasArmed, m_control.isArmed()) && m_wasArmed) {
        m_setpoint->setValue(0.0); // what was typed before is no set-point of this arming
    }
    const bool canMove = m_control.canMove();
    QWidget* const movers[] = {m_go, m_zero, m_jog};
    for (QWidget* mover : movers) {
        m_rest.setEnabled(*mover, canMove);
    }
    // The next reference would begin where this one is by then: nobody could say where it ends.
    m_rest.setEnabled(*m_start, canMove && !m_control.isRunning());
    m_rest.setEnabled(*m_end, m_control.isArmed() && m_control.isAvailable() && m_control.isRunning());
    showOrigin();
    showSetpoint();
    describeMotion();
}

/// A board of another maker is not armed by guessing how.
void DrivePanel::refreshForeign() {
    const bool isForeign = m_bench.session().state() == SessionState::Connected && !m_control.canDrive();
    if (isForeign && m_asking != Asking::NothingToDrive) {
        m_asking = Asking::NothingToDrive;
        const bool isOfAxes = m_control.hasSeveralAxes();
        m_message->showMessage(
            {widgets::Severity::Information,
             isOfAxes ? tr("This device has several axes: it is not armed or driven from here.")
                      : tr("This device cannot be armed, driven or stopped from here: it has no "
                           "parameter hb.arm."),
             isOfAxes ? tr("Drive it from the command line. STOP, Signals, Parameters and Record work here.")
                      : tr("Use its maker's program and the switch at the actuator. Signals, "
                           "Parameters and Record work with it by name."),
             {}});
    } else if (!isForeign && m_asking == Asking::NothingToDrive) {
        m_asking = Asking::Nothing;
        m_message->clear();
    }
}

void DrivePanel::refreshMode() {
    if (!m_control.isPending() && std::exchange(m_shownMode, m_control.mode()) != m_control.mode()) {
        refreshUnits();
    }
}

/// A latched stop stays in view until it is released on purpose.
void DrivePanel::refreshStop() {
    FaultWords words = m_control.isStopped()
                           ? faultWords(m_bench.session().report().board, m_bench.stopAsker())
                           : FaultWords();
    if (m_control.isStopped() && !m_bench.stopLatch().hasStopped()) {
        words.what = tr("A stop came while nothing was armed");
    }
    if (!words.what.isEmpty()) {
        const QString action = m_control.canRelease() ? tr("Release the stop") : QString();
        const widgets::Message& shown = m_message->message();
        if (m_asking != Asking::Release || shown.text != words.what || shown.actionText != action) {
            m_asking = Asking::Release;
            m_message->showMessage({widgets::Severity::Error, words.what, words.remedy, action});
        }
    } else if (m_asking == Asking::Release || (m_asking == Asking::Consent && !m_control.isAvailable())) {
        m_asking = Asking::Nothing;
        m_message->clear();
    }
}

void DrivePanel::refreshState() {
    const bool isArmed = m_control.isArmed();
    const bool isConnected = m_bench.session().state() == SessionState::Connected;
    QString state = tr("No device");
    widgets::Role role = widgets::Role::Muted;
    if (m_control.isStopped()) {
        state = tr("Stopped");
        role = widgets::Role::Bad;
    } else if (!m_bench.session().procedure().isEmpty()) {
        state = tr("%1 is running").arg(m_bench.session().procedure());
    } else if (isArmed) {
        const QString driven = drivenWords(m_control);
        state = driven.isEmpty() ? tr("Armed") : tr("Armed, %1").arg(driven);
        role = widgets::Role::Armed;
    } else if (isConnected) {
        const bool isKnown = m_control.canDrive() || m_control.hasSeveralAxes(); // the board says it
        state = isKnown ? tr("Disarmed") : tr("Not known");
    }
    m_state->setWords(state);
    m_state->setAccessibleName(tr("State: %1").arg(state));
    showRole(*m_state, role);
}

double DrivePanel::factor() const {
    return m_control.mode() == BoardMode::Position ? displayQuantity("rad", m_units).factor : 1.0;
}

QString DrivePanel::valueText(double value) const {
    const DisplayQuantity shown =
        displayQuantity(m_control.mode() == BoardMode::Position ? "rad" : "A", m_units);
    return widgets::fixedText(value * shown.factor, shown.decimals) + QChar(QChar::Nbsp) + shown.unit;
}

void DrivePanel::dressSetpoint() {
    constexpr double Farthest_deg = 36000.0;
    const bool isAngle = m_control.mode() == BoardMode::Position;
    const DisplayQuantity shown = displayQuantity(isAngle ? "rad" : "A", m_units);
    const double most = isAngle ? degreesToRadians(Farthest_deg) * shown.factor : 4.0;
    const double step = isAngle ? shownStep(shown, degreesToRadians(1.0)) : 0.1;
    dressNumberField(*m_setpoint, {tr("Set-point"),
                                   isAngle ? tr("Beside what a reference has moved it (Enter sends it)")
                                           : tr("Current (Enter sends it)"),
                                   shown.unit, shown.decimals, -most, most, step});
}

/// Of another mode: what was typed meant something else.
void DrivePanel::refreshUnits() {
    dressSetpoint();
    m_setpoint->setValue(0.0);
    m_jog->setAngular(m_control.mode() == BoardMode::Position);
    m_reference->setMode(m_control.mode());
    takePeak();
}

/// Every field shows the same motion in the units that are preferred now.
void DrivePanel::onUnits() {
    const double value = m_setpoint->value() / factor();
    m_units = m_bench.displayUnits();
    dressSetpoint();
    m_setpoint->setValue(value * factor());
    m_jog->setUnits(m_units);
    m_reference->setUnits(m_units);
    refresh();
}

void DrivePanel::refreshLive() {
    if (!isVisible()) {
        return;
    }
    m_limits->refreshLive();
    showSetpoint();
}

void DrivePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refresh();
    }
}

} // namespace halbench::app
