#pragma once

#include <QObject>

namespace halbench::app {

/// Esc means stop, whatever has the focus: it watches the keys of the whole application, modal dialogs, menus
/// and floating docks included, and lets every key go on to where it was meant for.
class StopGuard : public QObject {
    Q_OBJECT

public:
    explicit StopGuard(QObject* parent);
    ~StopGuard() override;

Q_SIGNALS:
    void stopRequested();
    void escapePressed(); ///< once a key, after the stop: for the log

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void tellOnce();

    bool m_isTold = false; ///< of the key press that goes through the widgets now
};

} // namespace halbench::app
