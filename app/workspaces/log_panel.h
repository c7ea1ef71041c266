#pragma once

#include "app/workspaces/workbench.h"

#include <QWidget>

namespace halbench::widgets {
class LogView;
}

namespace halbench::app {

/// What board, link, procedures and window said, newest last; bounded.
class LogPanel : public QWidget {
    Q_OBJECT

public:
    explicit LogPanel(Workbench& bench, QWidget* parent = nullptr);
    QString text() const;

private:
    void add(MessageLevel level, const QString& source, const QString& words);

    Workbench& m_bench;
    widgets::LogView* m_view = nullptr;
};

} // namespace halbench::app
