#pragma once

#include "app/workbench/workbench.h"

#include <QObject>

#include <vector>

class QAction;
class QMenu;

namespace halbench::app {

/// How many rows a second the plots get: as usual, or more, as far as the board and its link carry them
/// (resources/help/monitor.md, "Plots").
class MonitorRate : public QObject {
    Q_OBJECT

public:
    /// `panel` gets the action.
    MonitorRate(Workbench& bench, QWidget& panel);

    /// Opens the menu of what is possible now.
    QAction& action() { return *m_action; }
    /// 0: as usual.
    double rate_Hz() const { return m_rate_Hz; }
    void setRate_Hz(double rate_Hz);
    /// What can be chosen of what is plotted: more than usual, in steps of 1, 2, 5 and the most there is.
    std::vector<double> choices_Hz() const;
    /// Why the rate is not as it was chosen; empty: it is.
    QString loweredWords() const;

Q_SIGNALS:
    void changed();

private:
    void fill();

    Workbench& m_bench;
    double m_rate_Hz = 0.0;
    QMenu* m_menu = nullptr;
    QAction* m_action = nullptr;
};

} // namespace halbench::app
