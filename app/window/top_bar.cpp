#include "app/window/top_bar.h"

#include "app/window/docks/perspective_bar.h"
#include "app/window/record_button.h"
#include "app/workbench/drive_text.h"
#include "app/workbench/fault_text.h"
#include "app/workspaces/drive/arm_button.h"
#include "app/workspaces/drive/mode_box.h"
#include "app/workspaces/parts/focus_keeper.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/status_strip.h"
#include "widgets/controls/stop_button.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QShortcut>

namespace halbench::app {

namespace {

/// So much more must be free before a control takes its words back.
constexpr int GrowthCharacters = 4;

/// A recording by its file's name, a device by its address.
void showSource(widgets::StatusStrip& strip, Workbench& bench) {
    const devices::DeviceInfo& info = bench.session().info();
    if (info.transport == "replay") {
        const QString file = QString::fromStdString(info.uri).section(QLatin1Char(':'), 1);
        strip.setDevice(QFileInfo(file.section(QLatin1Char('?'), 0, 0)).fileName(),
                        widgets::SourceKind::Recording);
    } else {
        strip.setDevice(QString::fromStdString(info.uri),
                        info.isSimulated ? widgets::SourceKind::Simulation : widgets::SourceKind::Device);
    }
}

} // namespace

TopBar::TopBar(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(widgets::PanelMargin_px, widgets::GridStep_px, widgets::PanelMargin_px,
                            widgets::GridStep_px);
    row->setSpacing(widgets::PanelMargin_px);
    buildControls();
    row->addWidget(m_connection);
    row->addWidget(m_strip, 1);
    m_strip->addControl(*m_release);
    for (QWidget* control :
         std::initializer_list<QWidget*>{m_arm, m_mode, m_record, m_perspectives, m_stop}) {
        row->addWidget(control);
    }
    connectSession();
    refresh();
}

void TopBar::buildControls() {
    m_connection = new ConnectButton(m_bench, this);
    m_strip = new widgets::StatusStrip(this);
    m_arm = new ArmButton(m_bench.drive(), ArmButton::Key::Has, this);
    m_mode = new ModeBox(m_bench.drive(), QStringLiteral("Ctrl+M"), this);
    m_record = new RecordButton(m_bench, this);
    m_perspectives = new PerspectiveBar(this);
    m_release = makeButton({tr("Release"),
                            tr("Release the latched stop; does not arm. Locked shortly after a stop (Space)"),
                            {}},
                           this);
    connect(m_release, &QPushButton::clicked, this, &TopBar::release);
    m_stop = new widgets::StopButton(widgets::StopButton::Variant::Full, this);
    auto* chooseMode = new QShortcut(QKeySequence(QStringLiteral("Ctrl+M")), this);
    connect(chooseMode, &QShortcut::activated, this, [this] { m_mode->setFocus(Qt::ShortcutFocusReason); });
    connect(m_arm, &ArmButton::consentNeeded, this, &TopBar::consentNeeded);
    connect(m_perspectives, &PerspectiveBar::chosen, this, &TopBar::perspectiveChosen);
}

void TopBar::connectSession() {
    DeviceSession& session = m_bench.session();
    connect(m_stop, &widgets::StopButton::stopRequested, &session, &DeviceSession::stopActuator);
    connect(m_stop, &widgets::StopButton::stopRequested, this, &TopBar::stopPressed);
    connect(&m_bench.stopLatch(), &StopLatch::changed, this, &TopBar::refresh);
    connect(&m_bench.drive(), &DriveControl::changed, this, &TopBar::refresh);
    connect(&session, &DeviceSession::stateChanged, this, &TopBar::refresh);
    connect(&session, &DeviceSession::reportChanged, this, &TopBar::refresh);
    connect(&session, &DeviceSession::procedureChanged, this, &TopBar::refresh);
}

void TopBar::setPerspective(Perspective perspective) {
    m_perspectives->setPerspective(perspective);
}

void TopBar::setOffered(bool isDriven, bool isRecorded) {
    m_isDriven = isDriven;
    m_isRecorded = isRecorded;
    showControls();
}

void TopBar::setStateOnly(bool isStateOnly) {
    m_isStateOnly = isStateOnly;
    showControls();
}

void TopBar::showControls() {
    m_connection->setVisible(!m_isStateOnly);
    m_arm->setVisible(m_isDriven && !m_isStateOnly);
    m_mode->setVisible(m_isDriven && !m_isStateOnly && m_room != Room::Least);
    m_record->setVisible(m_isRecorded && !m_isStateOnly);
    m_perspectives->setVisible(!m_isStateOnly);
}

/// Against the widest form.
int TopBar::saved_px(Room room) const {
    if (room == Room::Wide) {
        return 0;
    }
    return m_connection->saved_px() + m_record->saved_px() +
           (room >= Room::Narrow ? m_perspectives->saved_px() : 0) +
           (room == Room::Least && m_isDriven ? m_mode->minimumSizeHint().width() + layout()->spacing() : 0);
}

int TopBar::needed_px(Room room) const {
    return layout()->totalMinimumSize().width() + saved_px(m_room) - saved_px(room);
}

QSize TopBar::minimumSizeHint() const {
    return {needed_px(Room::Least), layout()->totalMinimumSize().height()};
}

void TopBar::fit() {
    Room room = Room::Least;
    for (const Room wider : {Room::Narrow, Room::Icons, Room::Wide}) {
        // What a form saves is known to a few pixels: without a gap between growing and shrinking it would
        // do both in turn where they meet.
        const int gap_px = wider < m_room ? fontMetrics().averageCharWidth() * GrowthCharacters : 0;
        room = needed_px(wider) + gap_px <= width() ? wider : room;
    }
    if (room == m_room) {
        return;
    }
    m_room = room;
    m_connection->setToolButtonStyle(room == Room::Wide ? Qt::ToolButtonTextBesideIcon
                                                        : Qt::ToolButtonIconOnly);
    m_record->setShort(room != Room::Wide);
    m_perspectives->setCollapsed(room >= Room::Narrow);
    m_mode->setVisible(room != Room::Least && m_isDriven && !m_isStateOnly);
    // The layouts still know the sizes before the change, and the form would go back. Only here: what
    // invalidates a layout asks for another look at the form, and that without end.
    m_perspectives->layout()->invalidate();
    m_perspectives->updateGeometry();
    updateGeometry();
}

void TopBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

/// Words became longer or shorter.
bool TopBar::event(QEvent* event) {
    const bool isDone = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest) {
        fit();
    }
    return isDone;
}

void TopBar::release() {
    m_bench.stopLatch().release([&session = m_bench.session()](const Result<void>& cleared) {
        if (!cleared) {
            session.message(MessageLevel::Error, tr("stop"), widgets::inWords(cleared.error().message));
        }
    });
}

void TopBar::refresh() {
    const DeviceSession& session = m_bench.session();
    const devices::DeviceState& board = session.report().board;
    const QString fault = widgets::inWords(board.faultText);
    const QString reason = board.fault != 0                   ? fault
                           : m_bench.stopLatch().hasStopped() ? stopReason(board, m_bench.stopAsker())
                                                              : tr("device was disarmed");
    const bool isConnected = session.state() == SessionState::Connected;
    const StopLatch& latch = m_bench.stopLatch();
    m_stop->setLatched(latch.isLatched(), reason);
    FocusKeeper(*this).setEnabled(*m_release, latch.isLatched() && !latch.isLocked());
    m_strip->setControlShown(latch.isLatched());
    const bool hasSource = isConnected || session.isPlayedToTheEnd();
    if (hasSource || session.state() == SessionState::Reconnecting) {
        showSource(*m_strip, m_bench);
    } else {
        m_strip->clearDevice();
    }
    m_strip->setFaultLatched(isConnected && board.fault != 0);
    if (session.state() == SessionState::Reconnecting) {
        m_strip->setState(widgets::WorkState::Fault, tr("connection lost, reconnecting"));
    } else if (session.state() == SessionState::Lost && !hasSource) {
        m_strip->setState(widgets::WorkState::Fault, tr("connection lost"));
    } else if (!hasSource) {
        m_strip->setState(widgets::WorkState::Disconnected);
    } else if (board.fault != 0) {
        m_strip->setState(widgets::WorkState::Fault, fault);
    } else if (board.isStopLatched) {
        m_strip->setState(widgets::WorkState::Stopped, reason);
    } else if (!session.procedure().isEmpty()) {
        m_strip->setState(widgets::WorkState::Running, session.procedure());
    } else {
        m_strip->setState(board.isArmed ? widgets::WorkState::Armed : widgets::WorkState::Connected,
                          board.isArmed ? drivenWords(m_bench.drive()) : QString());
    }
}

} // namespace halbench::app
