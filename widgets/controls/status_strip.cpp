#include "widgets/controls/status_strip.h"

#include "widgets/controls/elided_label.h"
#include "widgets/theme/icons.h"

#include <QAccessible>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyleHints>

#include <algorithm>

namespace halbench::widgets {
namespace {

constexpr int Symbol_px = 16;
/// What is seen of long words when the window is narrow.
constexpr int DeviceCharacters = 7;
constexpr int StateCharacters = 13;
/// Of each, where a control stands beside them: it says the state as well.
constexpr int CharactersBesideControl = 3;

Role roleOfState(WorkState state) {
    switch (state) {
    case WorkState::Connected:
        return Role::Good;
    case WorkState::Armed:
    case WorkState::Running:
        return Role::Armed;
    case WorkState::Stopped:
    case WorkState::Fault:
        return Role::Bad;
    case WorkState::Disconnected:
        break;
    }
    return Role::Muted;
}

QString iconOfState(WorkState state) {
    switch (state) {
    case WorkState::Connected:
        return QStringLiteral("connect");
    case WorkState::Armed:
        return QStringLiteral("arm");
    case WorkState::Running:
        return QStringLiteral("play");
    case WorkState::Stopped:
        return QStringLiteral("stop");
    case WorkState::Fault:
        return QStringLiteral("warning");
    case WorkState::Disconnected:
        break;
    }
    return QStringLiteral("disconnect");
}

} // namespace

StatusStrip::StatusStrip(QWidget* parent)
    : QFrame(parent), m_deviceLabel(new ElidedLabel(DeviceCharacters, this)), m_kindBadge(new QLabel(this)),
      m_stateSymbol(new QLabel(this)), m_stateBadge(new ElidedLabel(StateCharacters, this)) {
    setProperty("surface", QStringLiteral("strip"));
    m_kindBadge->setProperty("badge", true);
    m_stateBadge->setProperty("badge", true);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(PanelMargin_px, GridStep_px, PanelMargin_px, GridStep_px);
    row->setSpacing(PanelMargin_px);
    row->addWidget(m_deviceLabel);
    row->addWidget(m_kindBadge);
    row->addSpacing(GridStep_px);
    row->addWidget(m_stateSymbol);
    row->addWidget(m_stateBadge);
    row->addStretch(1);
    connect(&m_blink, &QTimer::timeout, this, [this] {
        m_isSymbolShown = !m_isSymbolShown;
        refreshSymbol();
    });
    refresh();
}

void StatusStrip::setState(WorkState state, const QString& detail) {
    if (m_state == state && m_detail == detail) {
        return;
    }
    m_state = state;
    m_detail = detail;
    refresh();
    QAccessibleEvent alert(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void StatusStrip::setFaultLatched(bool isLatched) {
    const int period_ms = QGuiApplication::styleHints()->cursorFlashTime();
    const bool isBlinking = isLatched && period_ms > 0;
    if (isBlinking && !m_blink.isActive()) {
        m_blink.start(period_ms); // shown and hidden for a cursor's whole period: half as fast as it blinks
    } else if (!isBlinking && m_blink.isActive()) {
        m_blink.stop();
        m_isSymbolShown = true;
        refreshSymbol();
    }
}

void StatusStrip::setDevice(const QString& name, SourceKind kind) {
    if (name != m_device || kind != m_kind) {
        m_device = name;
        m_kind = kind;
        refresh();
    }
}

void StatusStrip::clearDevice() {
    setDevice({}, SourceKind::Device);
}

void StatusStrip::addControl(QWidget& control) {
    m_control = &control;
    layout()->addWidget(&control);
    control.hide();
}

void StatusStrip::setControlShown(bool isShown) {
    m_control->setVisible(isShown);
    m_deviceLabel->setLeastCharacters(isShown ? CharactersBesideControl : DeviceCharacters);
    m_stateBadge->setLeastCharacters(isShown ? CharactersBesideControl : StateCharacters);
}

QString StatusStrip::stateText() const {
    switch (m_state) {
    case WorkState::Connected:
        return m_kind == SourceKind::Recording ? tr("Open") : tr("Connected");
    case WorkState::Armed:
        return m_detail.isEmpty() ? tr("Armed") : tr("Armed: %1").arg(m_detail);
    case WorkState::Running:
        return m_detail.isEmpty() ? tr("Running") : tr("Running %1").arg(m_detail);
    case WorkState::Stopped:
        return m_detail.isEmpty() ? tr("Stopped") : tr("Stopped (%1)").arg(m_detail);
    case WorkState::Fault:
        return m_detail.isEmpty() ? tr("Fault") : tr("Fault (%1)").arg(m_detail);
    case WorkState::Disconnected:
        break;
    }
    return tr("Disconnected");
}

void StatusStrip::refresh() {
    const Role role = roleOfState(m_state);
    m_deviceLabel->setWords(m_device.isEmpty() ? tr("No device") : m_device);
    setRole(*m_deviceLabel, m_device.isEmpty() ? Role::Muted : Role::None);
    const bool isRecording = m_kind == SourceKind::Recording;
    m_kindBadge->setText(isRecording ? tr("RECORDING") : tr("SIMULATED"));
    m_kindBadge->setToolTip(isRecording ? tr("Recorded samples; no device is connected")
                                        : tr("Simulated device inside the program; no real motion"));
    setRole(*m_kindBadge, isRecording ? Role::Primary : Role::Simulated);
    m_kindBadge->setVisible(m_kind != SourceKind::Device);
    refreshSymbol();
    m_stateBadge->setWords(stateText());
    setRole(*m_stateBadge, role);
    setRole(*this, role);
    setAccessibleName(tr("State of the device"));
    const QString sentence = isRecording                        ? tr("%1, recording, %2")
                             : m_kind == SourceKind::Simulation ? tr("%1, simulated, %2")
                                                                : tr("%1, %2");
    setAccessibleDescription(sentence.arg(m_deviceLabel->words(), stateText()));
}

void StatusStrip::refreshSymbol() {
    QPixmap symbol = themedIcon(iconOfState(m_state), roleOfState(m_state)).pixmap(Symbol_px, Symbol_px);
    if (!m_isSymbolShown) {
        symbol.fill(Qt::transparent); // keeps its place
    }
    m_stateSymbol->setPixmap(symbol);
}

QSize StatusStrip::minimumSizeHint() const {
    const auto spared_px = [](const ElidedLabel& label, int characters) {
        return label.leastWidth_px(characters) - label.minimumSizeHint().width();
    };
    const QSize now = QFrame::minimumSizeHint();
    const int control_px = m_control == nullptr || m_control->isHidden()
                               ? 0
                               : m_control->minimumSizeHint().width() + layout()->spacing();
    // The wider of the two badges, shown or not.
    const QString other = m_kind == SourceKind::Recording ? tr("SIMULATED") : tr("RECORDING");
    const QFontMetrics letters = m_kindBadge->fontMetrics();
    const int wider_px =
        std::max(0, letters.horizontalAdvance(other) - letters.horizontalAdvance(m_kindBadge->text()));
    const int badge_px =
        wider_px + (m_kindBadge->isHidden() ? m_kindBadge->sizeHint().width() + layout()->spacing() : 0);
    return {now.width() + spared_px(*m_deviceLabel, DeviceCharacters) +
                spared_px(*m_stateBadge, StateCharacters) + badge_px - control_px,
            now.height()};
}

void StatusStrip::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::StyleChange) {
        refresh();
    }
}

} // namespace halbench::widgets
