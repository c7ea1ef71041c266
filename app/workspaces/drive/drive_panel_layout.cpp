// What the Drive panel consists of, from top to bottom.
#include "app/workbench/fault_text.h"
#include "app/workspaces/drive/arm_button.h"
#include "app/workspaces/drive/drive_limits.h"
#include "app/workspaces/drive/drive_panel.h"
#include "app/workspaces/drive/jog_row.h"
#include "app/workspaces/drive/mode_box.h"
#include "app/workspaces/drive/path_run.h"
#include "app/workspaces/drive/pose_pad.h"
#include "app/workspaces/drive/reference_form.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace halbench::app {

void DrivePanel::buildArm(QVBoxLayout* column) {
    auto* row = new QHBoxLayout;
    m_state->setProperty("badge", true);
    m_state->setAccessibleDescription(tr("State reported by the device"));
    auto* arm = new ArmButton(m_control, ArmButton::Key::IsToldOnly, this);
    row->addWidget(m_state, 1);
    row->addWidget(arm);
    column->addLayout(row);
    auto* modeRow = new QHBoxLayout;
    auto* label = new QLabel(tr("&Mode"), this);
    auto* mode = new ModeBox(m_control, QStringLiteral("Alt+M"), this);
    label->setBuddy(mode);
    modeRow->addWidget(label);
    modeRow->addWidget(mode, 1);
    column->addLayout(modeRow);
    m_axisRow = new QWidget(this);
    auto* axisRow = new QHBoxLayout(m_axisRow);
    axisRow->setContentsMargins(0, 0, 0, 0);
    auto* axisLabel = new QLabel(tr("A&xis"), m_axisRow);
    m_axes = new QComboBox(m_axisRow);
    m_axes->setAccessibleName(tr("Axis"));
    m_axes->setToolTip(tr("Axis for set-point, jog and reference; other axes hold (Alt+X)"));
    axisLabel->setBuddy(m_axes);
    axisRow->addWidget(axisLabel);
    axisRow->addWidget(m_axes, 1);
    column->addWidget(m_axisRow);
    connect(m_axes, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this] { m_control.chooseAxis(m_axes->currentData().toString().toStdString()); });
    connect(arm, &ArmButton::consentNeeded, this, [this] {
        m_asking = Asking::Consent;
        m_message->showMessage(armingWarning());
    });
}

void DrivePanel::buildSetpoint(QVBoxLayout* column) {
    QVBoxLayout* section = addSection(column, tr("Set-point and jog"), this);
    m_from = makeNote(this);
    section->addWidget(m_from);
    auto* row = new QHBoxLayout;
    row->setSpacing(widgets::GridStep_px);
    m_setpoint = makeNumberField({}, this);
    m_from->setBuddy(m_setpoint);
    m_go = makeButton(
        {tr("Go"), tr("Send the set-point (Enter in the field). Long moves\nare ramps at jog speed."), {}},
        this);
    m_zero = makeButton({tr("Zero"), tr("Send set-point zero"), {}}, this);
    row->addWidget(m_setpoint, 1);
    row->addWidget(m_go);
    row->addWidget(m_zero);
    section->addLayout(row);
    m_setpointNow = makeNote(this);
    reserveLines(*m_setpointNow, 2);
    section->addWidget(m_setpointNow);
    m_jog = new JogRow(this);
    section->addWidget(m_jog);
    m_pose = new PosePad(m_bench, this);
    section->addWidget(m_pose);
    connect(m_pose, &PosePad::refused, this, &DrivePanel::showError);
    // Only Enter sends: leaving the field must not move anything.
    connect(m_setpoint, &widgets::QuantityEdit::entered, this, &DrivePanel::onSetpoint);
    connect(m_setpoint, &widgets::QuantityEdit::refused, this, &DrivePanel::onSetpointRefused);
    connect(m_setpoint, &widgets::QuantityEdit::edited, this, &DrivePanel::forgetError);
    connect(m_go, &QPushButton::pressed, this, [this] { m_isGoRefused = m_isJustRefused; });
    connect(m_go, &QPushButton::clicked, this, [this] {
        if (!std::exchange(m_isGoRefused, false)) { // what was refused stays said
            onSetpoint();
        }
    });
    connect(m_zero, &QPushButton::clicked, this, [this] {
        m_setpoint->setValue(0.0);
        onSetpoint();
    });
    connect(m_jog, &JogRow::jogStarted, &m_control, &DriveControl::startJog);
    connect(m_jog, &JogRow::jogStopped, &m_control, &DriveControl::stopJog);
    connect(m_jog, &JogRow::refused, this, &DrivePanel::showError);
}

QString DrivePanel::startHelp() {
    return tr("Start the reference from the present set-point; repeated starts\nadd up (Ctrl+Shift+R)");
}

void DrivePanel::buildReference(QVBoxLayout* column) {
    QVBoxLayout* section = addSection(column, tr("Reference generator"), this);
    m_reference = new ReferenceForm(this);
    m_path = new PathRun(m_bench, m_reference->path(), this);
    section->addWidget(m_reference);
    auto* row = new QHBoxLayout;
    row->setSpacing(widgets::GridStep_px);
    m_start = makeButton({tr("Start"), startHelp(), QStringLiteral("play")}, this);
    m_start->setShortcut(QKeySequence(tr("Ctrl+Shift+R")));
    m_end =
        makeButton({tr("End"), tr("End the reference: position is held, current goes to 0 (Ctrl+Shift+E)"),
                    QStringLiteral("end")},
                   this);
    m_end->setShortcut(QKeySequence(tr("Ctrl+Shift+E")));
    row->addWidget(m_start, 1);
    row->addWidget(m_end, 1);
    section->addLayout(row);
    m_motion = makeNote(this);
    reserveLines(*m_motion, 3);
    section->addWidget(m_motion);
    connect(m_reference, &ReferenceForm::changed, this, &DrivePanel::takePeak);
    connect(m_reference, &ReferenceForm::changed, this, &DrivePanel::forgetError);
    connect(m_reference, &ReferenceForm::refused, this, &DrivePanel::showError);
    connect(m_start, &QPushButton::clicked, this, &DrivePanel::onStartReference);
    connect(m_end, &QPushButton::clicked, &m_control, &DriveControl::stopReference);
}

void DrivePanel::buildLimits(QVBoxLayout* column) {
    QVBoxLayout* section = addSection(column, tr("Device limits"), this);
    m_limits = new DriveLimits(m_bench, m_control, this);
    section->addWidget(m_limits);
    QLabel* until = makeNote(this);
    until->setText(tr("Lost at power-off. To keep: Parameters > Save to device."));
    section->addWidget(until);
    connect(m_limits, &DriveLimits::failed, this, &DrivePanel::showError);
}

} // namespace halbench::app
