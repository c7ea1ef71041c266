#include "app/workspaces/drive/arm_button.h"

#include "widgets/theme/icons.h"

#include <QEvent>
#include <QMouseEvent>
#include <QShortcut>

#include <algorithm>

namespace halbench::app {

widgets::Message armingWarning() {
    return {widgets::Severity::Warning, ArmButton::tr("When armed, the actuator can move at any time."),
            ArmButton::tr("Keep hands, hair, cables and loose parts clear. Esc stops it."),
            ArmButton::tr("Arm it")};
}

ArmButton::ArmButton(DriveControl& control, Key key, QWidget* parent)
    : QPushButton(parent), m_control(control), m_rest(*parent) {
    connect(this, &QPushButton::clicked, this, &ArmButton::onClicked);
    connect(&m_control, &DriveControl::changed, this, &ArmButton::refresh);
    if (key == Key::Has) {
        // Not the button's own shortcut, which a key that is held repeats: arm, disarm, arm.
        auto* press = new QShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+A")), this);
        press->setAutoRepeat(false);
        connect(press, &QShortcut::activated, this, &QPushButton::click);
    }
    sayWords();
    dress();
    refresh();
}

void ArmButton::onClicked() {
    if (m_control.isArmed()) {
        m_control.disarm();
    } else if (m_control.canArm() && m_control.needsConsent()) {
        m_control.askConsent();
        Q_EMIT consentNeeded();
    } else {
        m_control.arm();
    }
}

void ArmButton::refresh() {
    m_rest.setEnabled(*this, m_control.canArm() || m_control.canDisarm());
    if (m_control.isStopped()) {
        m_rest.forget(); // a key that follows the release must not arm
    }
    const widgets::Role role = m_control.isArmed() ? widgets::Role::Armed : widgets::Role::None;
    if (widgets::roleOf(*this) != role) {
        widgets::setRole(*this, role);
        sayWords();
        dress();
    }
}

void ArmButton::sayWords() {
    const bool isArmed = widgets::roleOf(*this) == widgets::Role::Armed;
    setText(isArmed ? tr("Disarm") : tr("Arm"));
    setToolTip(isArmed ? tr("Switch the current off, set-points to zero (Ctrl+Shift+A)")
                       : tr("Enable motion; set-points start at zero (Ctrl+Shift+A)"));
    setAccessibleDescription(toolTip());
}

QSize ArmButton::sizeHint() const {
    const auto width_px = [this](const QString& words) {
        return fontMetrics().size(Qt::TextShowMnemonic, words).width();
    };
    const QSize now = QPushButton::sizeHint();
    const int widest_px = std::max(width_px(tr("Arm")), width_px(tr("Disarm")));
    return {now.width() + widest_px - width_px(text()), now.height()};
}

/// The icon stands out from the armed colour.
void ArmButton::dress() {
    const widgets::Theme theme = widgets::currentTheme();
    const bool isArmed = widgets::roleOf(*this) == widgets::Role::Armed;
    setIcon(widgets::colouredIcon(QStringLiteral("arm"),
                                  isArmed ? widgets::readableOn(theme, theme.armed) : theme.text));
}

void ArmButton::mouseDoubleClickEvent(QMouseEvent* event) {
    event->accept();
}

void ArmButton::changeEvent(QEvent* event) {
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        sayWords();
    } else if (event->type() == QEvent::StyleChange) {
        dress();
    }
}

} // namespace halbench::app
