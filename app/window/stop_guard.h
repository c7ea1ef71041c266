#pragma once

#include <QObject>

#include <functional>

class QKeyEvent;

namespace halbench::app {

/// Esc means stop, whatever has the focus: it watches the keys of the whole application, modal dialogs,
/// menus, floating docks and drags included, and lets every key go on to where it was meant for. In a
/// WindowApplication nothing comes before it; in another one an event filter that is installed later does.
/// Where the owner knows that there is nothing to stop, Esc is what it is elsewhere: it leaves fields and
/// closes menus, and stops nothing.
class StopGuard : public QObject {
    Q_OBJECT

public:
    explicit StopGuard(QObject* parent);
    ~StopGuard() override;
    /// Whether it is certain that nothing moves or may begin to; without an answer Esc always stops.
    void setNothingToStop(std::function<bool()> isNothingToStop);

Q_SIGNALS:
    void stopRequested();
    void escapePressed(); ///< once a key, after the stop: for the log

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void onKey(const QKeyEvent& event);
    void tellOnce();

    std::function<bool()> m_isNothingToStop;
    bool m_isTold = false; ///< of the key press that goes through the widgets now
};

} // namespace halbench::app
