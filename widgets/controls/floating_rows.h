#pragma once

#include <QWidget>

class QVBoxLayout;

namespace halbench::widgets {

/// Rows that come and go over a right corner of another widget: what stands below them neither moves
/// nor changes its size. Without a row in sight there is nothing.
class FloatingRows : public QWidget {
    Q_OBJECT
public:
    /// Over `below`, which is `parent` or a descendant of it; at its Qt::TopEdge or Qt::BottomEdge.
    FloatingRows(QWidget& below, Qt::Edge edge, QWidget* parent);

    void addRow(QWidget& row);

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QWidget& m_below;
    Qt::Edge m_edge;
    QVBoxLayout* m_column = nullptr;
};

} // namespace halbench::widgets
