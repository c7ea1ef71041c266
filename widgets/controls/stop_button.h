#pragma once

#include <QPushButton>
#include <QString>

namespace halbench::widgets {

/// The software stop. It acts when it is pressed, not when it is let go, and every press stops, latched or
/// not; it never releases. It looks the same in both: that it stopped is said beside it, in the state. Esc
/// belongs to the window, which calls the same.
class StopButton : public QPushButton {
    Q_OBJECT
public:
    enum class Variant {
        Full,   ///< at least 88 x 40 px, for the window
        Compact ///< for dialogs and floating docks
    };
    explicit StopButton(Variant variant, QWidget* parent = nullptr);

    bool isLatched() const { return m_isLatched; }

    /// Why it stopped, in the user's words; empty if there is nothing to say.
    void setLatched(bool isLatched, const QString& reason = {});

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void stopRequested();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    Variant m_variant;
    bool m_isLatched = false;
    QString m_reason;
};

} // namespace halbench::widgets
