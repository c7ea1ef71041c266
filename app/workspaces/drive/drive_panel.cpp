#include "app/workspaces/drive/drive_panel.h"

#include "app/procedures/base/axis_choice.h"
#include "app/workbench/drive_ability.h"
#include "app/workbench/drive_text.h"
#include "app/workbench/fault_text.h"
#include "app/workspaces/drive/axis_ranges.h"
#include "app/workspaces/drive/drive_limits.h"
#include "app/workspaces/drive/jog_row.h"
#include "app/workspaces/drive/path_form.h"
#include "app/workspaces/drive/path_run.h"
#include "app/workspaces/drive/pose_pad.h"
#include "app/workspaces/drive/reference_form.h"
#include "app/workspaces/parts/panel_parts.h"
#include "control/base/units.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

namespace halbench::app {

namespace {

using devices::BoardMode;
constexpr int LivePeriod_ms = 100;
constexpr int LeastState = 8; ///< characters of the state; the rest in its tooltip

/// What the drive shows of the device, whatever the plots show.
std::vector<std::string> shownSignals(const devices::Catalogue& catalogue) {
    std::vector<std::string> names = {"reference.running"};
    for (const devices::AxisSpec& axis : axesOf(catalogue)) {
        for (const std::string& role :
             {axis.roles.position, axis.roles.speed, axis.roles.reference, axis.roles.effort}) {
            names.push_back(signalOfRole(catalogue, role));
        }
    }
    for (const SignalSpec& spec : catalogue.signals) {
        if (spec.role.starts_with("coil_temperature.") || spec.role.starts_with("current.")) {
            names.push_back(spec.name);
        }
    }
    return names;
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
    setFocusProxy(m_setpoint); // never Arm: a key that follows would arm
    column->addStretch(1);
    layout()->addWidget(m_message); // at the end, so that nothing moves away from under the mouse
    connect(m_message, &widgets::MessageBar::actionTriggered, this, &DrivePanel::onMessageAction);
    connect(m_message, &widgets::MessageBar::dismissed, this, [this] {
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
    m_bench.liveSignals().want(this, shownSignals(m_bench.session().catalogue()));
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

void DrivePanel::setFileChooser(FileChooser chooser) {
    m_path->setFileChooser(std::move(chooser));
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
        showError(tr("%1 is outside the excursion window. Nothing was sent.").arg(valueText(wanted)),
                  tr("Allowed now: %1 to %2. Widen the window, or disarm and arm to set a new zero.")
                      .arg(valueText(range_rad->first), valueText(range_rad->second)));
        return;
    }
    forgetError();
    m_control.setSetpoint(wanted, m_jog->speed());
}

/// Nothing is sent; a field that was left shows what holds, so that a Go behind it moves nothing either.
void DrivePanel::onSetpointRefused(const QString& text) {
    if (!m_setpoint->hasFocus()) {
        m_setpoint->setValue(m_control.goal() * factor());
        m_isJustRefused = true; // a mouse on Go takes the focus first and presses then
        QTimer::singleShot(0, this, [this] { m_isJustRefused = false; });
    }
    showError(tr("'%1' is not a valid set-point. Nothing was sent.").arg(text.trimmed()),
              m_setpoint->problemOf(text));
}

void DrivePanel::onStartReference() {
    if (m_reference->isPath()) {
        forgetError();
        if (const Result<void> started = m_path->start(); !started) {
            showError(widgets::inWords(started.error().message), widgets::inWords(started.error().hint));
        }
        return;
    }
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
    refreshStop();
    refreshState();
    refreshAxes();
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
    m_pose->refresh();
    showOrigin();
    showSetpoint();
    describeMotion();
}

/// The choice is seen where there is one.
void DrivePanel::refreshAxes() {
    const std::vector<devices::AxisSpec> axes = m_control.axes();
    const QSignalBlocker quiet(m_axes);
    bool isSame = m_axes->count() == static_cast<int>(axes.size());
    for (std::size_t i = 0; isSame && i < axes.size(); ++i) {
        isSame = m_axes->itemData(static_cast<int>(i)).toString().toStdString() == axes[i].id;
    }
    if (!isSame) {
        m_axes->clear();
        for (const devices::AxisSpec& axis : axes) {
            m_axes->addItem(QString::fromStdString(axis.title), QString::fromStdString(axis.id));
        }
        m_bench.liveSignals().want(this, shownSignals(m_bench.session().catalogue()));
    }
    m_reference->setPaths(offeredPaths(m_bench.session().catalogue()));
    m_axes->setCurrentIndex(m_axes->findData(QString::fromStdString(m_control.axis().id)));
    m_axisRow->setVisible(axes.size() > 1);
    m_rest.setEnabled(*m_axes, m_control.canChooseAxis());
}

void DrivePanel::refreshMode() {
    if (m_control.isPending()) {
        return;
    }
    const bool isOtherMode = std::exchange(m_shownMode, m_control.mode()) != m_control.mode();
    const bool isOtherAxis = std::exchange(m_shownAxis, m_control.axis().id) != m_control.axis().id;
    if (isOtherMode || isOtherAxis) {
        refreshUnits();
    }
}

/// A latched stop stays in view until it is released on purpose.
void DrivePanel::refreshStop() {
    FaultWords words = m_control.isStopped()
                           ? faultWords(m_bench.session().report().board, m_bench.stopAsker())
                           : FaultWords();
    if (m_control.isStopped() && !m_bench.stopLatch().hasStopped()) {
        words.what = tr("Stopped while disarmed");
    }
    if (!words.what.isEmpty()) {
        const QString action = m_control.canRelease() ? tr("Release") : QString();
        const widgets::Message& shown = m_message->message();
        if (m_asking != Asking::Release || shown.text != words.what || shown.actionText != action) {
            m_asking = Asking::Release;
            // A fault says what to do first; a stop is only released.
            const bool isOneRow = m_bench.session().report().board.fault == 0;
            m_message->showMessage({widgets::Severity::Error, words.what, words.remedy, action, isOneRow});
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
        state = driven.isEmpty() ? tr("Armed") : tr("Armed: %1").arg(driven);
        role = widgets::Role::Armed;
    } else if (isConnected) {
        state = m_control.canDrive() ? tr("Disarmed") : tr("Unknown"); // the board says it
    }
    m_state->setWords(state);
    m_state->setAccessibleName(tr("State: %1").arg(state));
    showRole(*m_state, role);
}

std::string DrivePanel::unit() const {
    return m_control.mode() == BoardMode::Position ? m_control.axis().positionUnit : std::string("A");
}

double DrivePanel::factor() const {
    return displayQuantity(unit(), m_units).factor;
}

QString DrivePanel::valueText(double value) const {
    const DisplayQuantity shown = displayQuantity(unit(), m_units);
    return widgets::fixedText(value * shown.factor, shown.decimals) + QChar(QChar::Nbsp) + shown.unit;
}

void DrivePanel::dressSetpoint() {
    constexpr double Farthest_deg = 36000.0;
    const bool isAngle = m_control.mode() == BoardMode::Position;
    const DisplayQuantity shown = displayQuantity(unit(), m_units);
    const double degree = perDegree(m_control.axis());
    const double most = isAngle ? Farthest_deg * degree * shown.factor : 4.0;
    const double step = isAngle ? shownStep(shown, degree) : 0.1;
    dressNumberField(*m_setpoint,
                     {tr("Set-point"),
                      isAngle ? tr("Without the offset from a finished reference (Enter sends it)")
                              : tr("Current (Enter sends it)"),
                      shown.unit, shown.decimals, -most, most, step});
}

/// Of another mode: what was typed meant something else.
void DrivePanel::refreshUnits() {
    dressSetpoint();
    m_setpoint->setValue(0.0);
    m_jog->setQuantity(m_control.mode() == BoardMode::Position, m_control.axis());
    m_reference->setMode(m_control.mode(), m_control.axis());
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
