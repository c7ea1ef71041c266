#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

class QLabel;

namespace halbench::app {

/// One line: rate, losses and latency of the link, state of the board.
class LinkPanel : public QWidget {
    Q_OBJECT

public:
    explicit LinkPanel(Workbench& bench, QWidget* parent = nullptr);

private:
    void refresh();

    Workbench& m_bench;
    QLabel* m_link = nullptr;
    QLabel* m_board = nullptr;
    std::uint64_t m_packets = 0;
    double m_time_s = 0.0;
    double m_rate_Hz = 0.0;
};

} // namespace halbench::app
