#include "app/window/top_bar.h"

#include "app/workspaces/fault_words.h"
#include "app/workspaces/recording_control.h"
#include "widgets/icons.h"
#include "widgets/phrasebook.h"
#include "widgets/status_strip.h"
#include "widgets/stop_button.h"
#include "widgets/theme_style.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QToolButton>

namespace halbench::app {

TopBar::TopBar(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_strip = new widgets::StatusStrip(this);
    m_stop = new widgets::StopButton(widgets::StopButton::Variant::Full, this);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(widgets::PanelMargin_px, widgets::GridStep_px, widgets::PanelMargin_px,
                            widgets::GridStep_px);
    row->setSpacing(widgets::GroupSpacing_px);
    row->addWidget(m_strip, 1);
    buildRecord();
    buildPerspectives();
    row->addWidget(m_stop);

    DeviceSession& session = m_bench.session();
    connect(m_stop, &widgets::StopButton::stopRequested, &session, &DeviceSession::stopActuator);
    connect(m_stop, &widgets::StopButton::stopRequested, this, &TopBar::stopPressed);
    connect(m_stop, &widgets::StopButton::rearmRequested, this, &TopBar::rearm);
    connect(&m_bench.stopLatch(), &StopLatch::changed, this, &TopBar::refresh);
    connect(&session, &DeviceSession::stateChanged, this, &TopBar::refresh);
    connect(&session, &DeviceSession::reportChanged, this, &TopBar::refresh);
    connect(&session, &DeviceSession::procedureChanged, this, &TopBar::refresh);
    refresh();
}

void TopBar::buildPerspectives() {
    auto* group = new QButtonGroup(this);
    int number = 0;
    for (const Perspective perspective : AllPerspectives) {
        auto* button = new QToolButton(this);
        button->setText(perspectiveTitle(perspective));
        button->setCheckable(true);
        button->setShortcut(QKeySequence(QString("Ctrl+%1").arg(++number)));
        button->setToolTip(tr("Arrange the panels for %1 (%2)")
                               .arg(perspectiveTitle(perspective).replace("&&", "&"),
                                    button->shortcut().toString(QKeySequence::NativeText)));
        button->setAccessibleName(tr("Perspective %1").arg(perspectiveTitle(perspective).replace("&&", "&")));
        group->addButton(button);
        m_perspectives.insert(static_cast<int>(perspective), button);
        layout()->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, perspective] { perspectiveChosen(perspective); });
    }
    setPerspective(Perspective::Monitor);
}

void TopBar::buildRecord() {
    m_record = new QToolButton(this);
    m_record->setText(tr("Record"));
    m_record->setIcon(widgets::themedIcon(QStringLiteral("record"), widgets::Role::Bad));
    static_cast<QToolButton*>(m_record)->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_record->setCheckable(true);
    m_record->setShortcut(QKeySequence(tr("Ctrl+R")));
    m_record->setToolTip(tr("Write what is measured to a file, or end that (Ctrl+R)"));
    layout()->addWidget(m_record);
    RecordingControl& recording = m_bench.recording();
    connect(m_record, &QAbstractButton::clicked, this, [this, &recording](bool isWanted) {
        if (isWanted) {
            recording.start();
        } else {
            recording.stop();
        }
        refreshRecording();
    });
    connect(&recording, &RecordingControl::changed, this, &TopBar::refreshRecording);
    connect(&recording, &RecordingControl::failed, this, [this](const QString& text, const QString& remedy) {
        m_bench.session().message(MessageLevel::Error, tr("recording"), text + QLatin1Char(' ') + remedy);
    });
    connect(&recording, &RecordingControl::finished, this, [this](const QString& path) {
        m_bench.session().message(MessageLevel::Info, tr("recording"), tr("written: %1").arg(path));
    });
    refreshRecording();
}

void TopBar::refreshRecording() {
    const RecordingControl& recording = m_bench.recording();
    m_record->setChecked(recording.isRecording());
    m_record->setEnabled(recording.isRecording() || m_bench.session().state() == SessionState::Connected);
    m_strip->setRecording(recording.isRecording(), recording.status().elapsed_s);
}

void TopBar::setPerspective(Perspective perspective) {
    m_perspectives.value(static_cast<int>(perspective))->setChecked(true);
}

void TopBar::rearm() {
    m_bench.stopLatch().release([&session = m_bench.session()](const Result<void>& cleared) {
        if (!cleared) {
            session.message(MessageLevel::Error, tr("stop"), widgets::inWords(cleared.error().message));
        }
    });
}

void TopBar::refresh() {
    const DeviceSession& session = m_bench.session();
    const devices::DeviceState& board = session.report().board;
    refreshRecording();
    const QString fault = widgets::inWords(board.faultText);
    const bool isConnected = session.state() == SessionState::Connected;
    m_stop->setLatched(m_bench.stopLatch().isLatched(), m_bench.stopLatch().isLocked(),
                       board.fault != 0 ? fault : stopReason(board));
    if (isConnected || session.state() == SessionState::Reconnecting) {
        m_strip->setDevice(QString::fromStdString(session.info().uri), session.info().isSimulated);
    } else {
        m_strip->clearDevice();
    }
    m_strip->setFaultLatched(isConnected && board.fault != 0);
    if (session.state() == SessionState::Reconnecting) {
        m_strip->setState(widgets::WorkState::Fault, tr("connection lost, reconnecting"));
    } else if (session.state() == SessionState::Lost) {
        m_strip->setState(widgets::WorkState::Fault, tr("connection lost"));
    } else if (!isConnected) {
        m_strip->setState(widgets::WorkState::Disconnected);
    } else if (board.fault != 0) {
        m_strip->setState(widgets::WorkState::Fault, fault);
    } else if (board.isStopLatched) {
        m_strip->setState(widgets::WorkState::Stopped, stopReason(board));
    } else if (!session.procedure().isEmpty()) {
        m_strip->setState(widgets::WorkState::Running, session.procedure());
    } else {
        m_strip->setState(board.isArmed ? widgets::WorkState::Armed : widgets::WorkState::Connected);
    }
}

} // namespace halbench::app
