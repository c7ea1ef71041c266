#pragma once

#include <QPushButton>
#include <QString>

namespace halbench::widgets {

/// The software stop. It acts when it is pressed, not when it is let go, and every press stops, latched or
/// not. While latched a complete click asks for re-arming too, unless that is still locked. Esc belongs to
/// the window, which calls the same.
class StopButton : public QPushButton {
    Q_OBJECT
public:
    enum class Variant {
        Full,   ///< at least 88 x 40 px, for the window
        Compact ///< for dialogs and floating docks
    };
    explicit StopButton(Variant variant, QWidget* parent = nullptr);

    bool isLatched() const { return m_isLatched; }

    /// `isLocked`: too early to re-arm. Why it stopped, in the user's words; empty if there is nothing to
    /// say.
    void setLatched(bool isLatched, bool isLocked, const QString& reason = {});

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void stopRequested();
    void rearmRequested();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void onPressed();
    void onClicked();
    void refresh();

    Variant m_variant;
    bool m_isLatched = false;
    bool m_isLocked = false;
    bool m_wasReadyToRearm = false;
    QString m_reason;
};

} // namespace halbench::widgets
