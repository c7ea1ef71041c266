#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

class QToolButton;

namespace halbench::widgets {
class ElidedLabel;
}

namespace halbench::app {

/// One line: rate, losses and latency of the link, state of the board.
class LinkPanel : public QWidget {
    Q_OBJECT

public:
    explicit LinkPanel(Workbench& bench, QWidget* parent = nullptr);

    /// The last line of the log; a click on it asks for the whole log.
    void showLine(MessageLevel level, const QString& text);

Q_SIGNALS:
    void logRequested();

private:
    QString streamWords() const; ///< rate and lost samples of what comes to the plots
    void refresh();

    Workbench& m_bench;
    widgets::ElidedLabel* m_line = nullptr;
    QToolButton* m_log = nullptr;
    widgets::ElidedLabel* m_stream = nullptr;
    widgets::ElidedLabel* m_link = nullptr;
    std::uint64_t m_packets = 0;
    double m_time_s = 0.0;
    double m_rate_Hz = 0.0;
};

} // namespace halbench::app
