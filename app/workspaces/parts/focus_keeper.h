#pragma once

#include <QPointer>
#include <QWidget>

namespace halbench::app {

/// Where the focus waits while a control that had it cannot be used. Qt gives it to the next one in the
/// chain, and the keys that were meant for the first change something there.
class FocusKeeper {
public:
    /// `rest`: a widget that takes no keys.
    explicit FocusKeeper(QWidget& rest) : m_rest(rest) {}

    /// Enables or disables; who is enabled again gets the focus back unless it was put elsewhere since.
    void setEnabled(QWidget& control, bool isEnabled);
    /// Nobody gets the focus back.
    void forget() { m_left.clear(); }

private:
    QWidget& m_rest;
    QPointer<QWidget> m_left; ///< had the focus
};

} // namespace halbench::app
