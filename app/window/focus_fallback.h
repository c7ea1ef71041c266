#pragma once

#include <QObject>
#include <QPointer>

#include <vector>

class QStackedWidget;
class QWidget;

namespace halbench::app {

/// Keyboard focus after its widget was hidden, disabled, closed or moved into another window. Qt gives it to
/// the next widget in the chain, where the next key may arm or start something. Here it goes back to the
/// widget with which the user worked last in the same panel, else to the nearest visible container, which
/// takes no keys. Buttons never get it this way. Tab and the mouse move the focus as ever. GUI thread.
class FocusFallback : public QObject {
    Q_OBJECT

public:
    /// `home`: where the focus goes when a whole window is gone; takes no keys.
    FocusFallback(QWidget& home, QObject* parent);
    ~FocusFallback() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void leave(const QWidget& hidden);
    void holdUntilPage(QStackedWidget& pages, QWidget& place);
    void onFocusChanged(QWidget* old, QWidget* now);
    void remember(QWidget& widget);
    bool isKnown(const QWidget& widget) const;
    QWidget* placeAfter(const QWidget& window) const;
    QWidget* placeFor(const QWidget* left, const QWidget& window) const;

    QPointer<QWidget> m_home;
    std::vector<QPointer<QWidget>> m_recent; ///< which had the focus, the newest last
    QPointer<QWidget> m_held;                ///< has the focus of a page that goes
    bool m_isByWindow = false;               ///< the focus comes because its window became the active one
};

} // namespace halbench::app
