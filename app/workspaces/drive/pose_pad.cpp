#include "app/workspaces/drive/pose_pad.h"

#include "app/workbench/drive_ability.h"
#include "app/workspaces/drive/axis_ranges.h"
#include "app/workspaces/drive/jog_row.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPointer>
#include <QPushButton>

#include <array>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

constexpr double Speed_deg_s = 45.0;     ///< as a degree stands for, on each axis
constexpr double Farthest_deg = 36000.0; ///< likewise
constexpr double Same = 1e-9;            ///< set-points that differ by less are one

struct JogKey {
    int key;
    std::size_t axis;
    double sign;
};
constexpr std::array Keys = {JogKey{Qt::Key_Left, 0, -1.0},     JogKey{Qt::Key_Right, 0, 1.0},
                             JogKey{Qt::Key_Down, 1, -1.0},     JogKey{Qt::Key_Up, 1, 1.0},
                             JogKey{Qt::Key_PageDown, 2, -1.0}, JogKey{Qt::Key_PageUp, 2, 1.0}};

} // namespace

PosePad::PosePad(Workbench& bench, QWidget* parent)
    : QWidget(parent), m_bench(bench), m_control(bench.drive()), m_grid(new QGridLayout(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Jog pad"));
    setToolTip(tr("Arrow keys jog the first two axes, Page Up and Page Down the third, while they are held"));
    m_grid->setContentsMargins(widgets::GridStep_px, widgets::GridStep_px, widgets::GridStep_px,
                               widgets::GridStep_px);
    m_grid->setSpacing(widgets::GridStep_px);
    m_grid->setColumnStretch(2, 1);
    m_go = makeButton(
        {tr("Go to pose"), tr("Goes to this pose, one axis after the other, as even ramps"), {}}, this);
    m_here = makeButton({tr("Here"), tr("Takes the pose where it is now"), {}}, this);
    m_home =
        makeButton({tr("Home"), tr("Counts the pitch cells from the present one; nothing moves"), {}}, this);
    connect(m_go, &QPushButton::clicked, this, &PosePad::goToPose);
    connect(m_here, &QPushButton::clicked, this, &PosePad::takePose);
    connect(m_home, &QPushButton::clicked, this, &PosePad::home);
    connect(&m_control, &DriveControl::changed, this, &PosePad::goOn);
    connect(&m_control, &DriveControl::failed, this, [this] { m_way.clear(); });
    refresh();
}

void PosePad::refresh() {
    const std::vector<devices::AxisSpec> axes = m_control.axes();
    bool isSame = axes.size() == m_rows.size();
    for (std::size_t i = 0; isSame && i < axes.size(); ++i) {
        isSame = axes[i].id == m_rows[i].axis;
    }
    const bool areSeveral = m_control.hasSeveralAxes();
    if (areSeveral && !isSame) {
        rebuild();
    }
    setVisible(areSeveral);
    const bool canMove = m_control.canMove();
    for (const Row& row : m_rows) {
        row.back->setEnabled(canMove);
        row.forward->setEnabled(canMove);
    }
    m_go->setEnabled(canMove && m_way.empty());
    const std::string home = m_bench.session().catalogue().parameterForRole("home");
    m_home->setVisible(!home.empty());
    m_home->setEnabled(!home.empty() && m_control.isAvailable() && !m_control.isArmed());
}

void PosePad::rebuild() {
    while (QLayoutItem* item = m_grid->takeAt(0)) {
        QWidget* widget = item->widget();
        if (widget != m_go && widget != m_here && widget != m_home) {
            delete widget;
        }
        delete item;
    }
    m_rows.clear();
    m_way.clear();
    int line = 0;
    for (const devices::AxisSpec& axis : m_control.axes()) {
        addRow(axis, line++);
    }
    m_grid->addWidget(m_here, line, 0, 1, 2);
    m_grid->addWidget(m_go, line, 2);
    m_grid->addWidget(m_home, line, 3);
}

void PosePad::addRow(const devices::AxisSpec& axis, int line) {
    const QString title = QString::fromStdString(axis.title);
    const DisplayQuantity shown = displayQuantity(axis.positionUnit, m_bench.displayUnits());
    const double most = Farthest_deg * perDegree(axis) * shown.factor;
    const std::size_t index = m_rows.size();
    const auto button = [&](const QString& text, const QString& name, double sign) {
        auto* held = new HoldButton(text, this);
        held->setAccessibleName(name);
        held->setToolTip(tr("%1 while it is held (hold Space)").arg(name));
        connect(held, &HoldButton::held, this, [this, index, sign] { jog(index, sign); });
        connect(held, &HoldButton::letGo, &m_control, &DriveControl::stopJog);
        return held;
    };
    Row row{axis.id,
            makeNumberField({tr("Position %1").arg(title), tr("Position to go to, absolute"), shown.unit,
                             shown.decimals, -most, most, shownStep(shown, perDegree(axis))},
                            this),
            button(QStringLiteral("−"), tr("Jog %1 backward").arg(title), -1.0),
            button(QStringLiteral("+"), tr("Jog %1 forward").arg(title), 1.0)};
    m_grid->addWidget(new QLabel(title, this), line, 0);
    m_grid->addWidget(row.back, line, 1);
    m_grid->addWidget(row.goal, line, 2);
    m_grid->addWidget(row.forward, line, 3);
    m_rows.push_back(std::move(row));
}

void PosePad::jog(std::size_t axis, double sign) {
    if (axis >= m_rows.size() || !m_control.canMove() || !m_control.canChooseAxis()) {
        return;
    }
    m_way.clear();
    m_control.chooseAxis(m_rows[axis].axis);
    m_control.startJog(sign * Speed_deg_s * perDegree(m_control.axis()));
}

void PosePad::goToPose() {
    m_way.clear();
    m_sent.reset();
    for (const devices::AxisSpec& axis : m_control.axes()) {
        const DisplayQuantity shown = displayQuantity(axis.positionUnit, m_bench.displayUnits());
        for (const Row& row : m_rows) {
            if (row.axis == axis.id) {
                row.goal->interpretText();
                m_way.emplace_back(axis.id, row.goal->value() / shown.factor);
            }
        }
    }
    goOn();
}

/// The next axis begins when the one before has arrived.
void PosePad::goOn() {
    if (m_isGoing) { // choosing an axis tells us too
        return;
    }
    if (!m_control.isArmed()) {
        m_way.clear();
        m_sent.reset();
    }
    const bool hasArrived = !m_sent || std::abs(m_control.setpoint() - *m_sent) <= Same * std::abs(*m_sent);
    if (!m_way.empty() && hasArrived && m_control.canMove() && m_control.canChooseAxis()) {
        m_isGoing = true;
        sendNext();
        m_isGoing = false;
    }
}

void PosePad::sendNext() {
    m_sent.reset();
    const auto [axis, position] = m_way.front();
    m_way.pop_front();
    m_control.chooseAxis(axis);
    if (!m_control.origin_rad()) {
        m_way.clear();
        return;
    }
    const double setpoint = position - *m_control.origin_rad() - m_control.held_rad();
    const auto range = m_control.setpointRange_rad();
    if (range && (setpoint < range->first || setpoint > range->second)) {
        m_way.clear();
        Q_EMIT refused(tr("The pose is beyond the excursion window of axis %1; nothing more was sent.")
                           .arg(QString::fromStdString(m_control.axis().title)),
                       tr("Widen the window on purpose, or disarm and arm to count anew."));
        return;
    }
    m_sent = setpoint;
    m_control.setSetpoint(setpoint, Speed_deg_s * perDegree(m_control.axis()));
}

void PosePad::takePose() {
    for (const devices::AxisSpec& axis : m_control.axes()) {
        const DisplayQuantity shown = displayQuantity(axis.positionUnit, m_bench.displayUnits());
        const auto now =
            m_bench.history().latest(signalOfRole(m_bench.session().catalogue(), axis.roles.position));
        for (const Row& row : m_rows) {
            if (row.axis == axis.id && now && std::isfinite(now->value)) {
                row.goal->setQuantity(now->value * shown.factor);
            }
        }
    }
}

void PosePad::home() {
    const std::string name = m_bench.session().catalogue().parameterForRole("home");
    const QPointer<PosePad> self(this);
    m_bench.writeValues({{name, 1.0}}, [self](const Result<void>& written) {
        if (self && !written) {
            Q_EMIT self->refused(widgets::inWords(written.error().message),
                                 widgets::inWords(written.error().hint));
        }
    });
}

void PosePad::keyPressEvent(QKeyEvent* event) {
    for (const JogKey& each : Keys) {
        if (each.key == event->key()) {
            if (!event->isAutoRepeat() && m_heldKey == 0) {
                m_heldKey = each.key;
                jog(each.axis, each.sign);
            }
            event->accept();
            return;
        }
    }
    QWidget::keyPressEvent(event);
}

void PosePad::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == m_heldKey && !event->isAutoRepeat()) {
        m_heldKey = 0;
        m_control.stopJog();
        event->accept();
        return;
    }
    QWidget::keyReleaseEvent(event);
}

void PosePad::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    if (std::exchange(m_heldKey, 0) != 0) {
        m_control.stopJog();
    }
    update();
}

void PosePad::paintEvent(QPaintEvent* event) {
    QWidget::paintEvent(event);
    QPainter painter(this);
    const widgets::Theme theme = widgets::currentTheme();
    painter.setPen(QPen(hasFocus() ? theme.accent : theme.line, 1.0));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

} // namespace halbench::app
