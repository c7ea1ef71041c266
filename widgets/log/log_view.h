#pragma once

#include "widgets/log/log_table_model.h"

#include <QWidget>

class QAction;
class QComboBox;
class QLineEdit;
class QTableView;

namespace halbench::widgets {

class LogFilterModel;

/// What happened, newest last: filter by words and by level, copy, follow. It stops following when the user
/// scrolls up and follows again at the end.
class LogView : public QWidget {
    Q_OBJECT
public:
    explicit LogView(QWidget* parent = nullptr);

    void append(const std::vector<LogEntry>& entries);
    /// All messages, a line each, whatever is filtered.
    QString text() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void createView();
    void createActions();
    void layOut();
    void copySelected();
    void retranslate();

    LogTableModel* m_model = nullptr;
    LogFilterModel* m_filter = nullptr;
    QLineEdit* m_search = nullptr;
    QComboBox* m_level = nullptr;
    QTableView* m_view = nullptr;
    bool m_isFollowing = true; ///< until the user scrolls up
    QAction* m_copy = nullptr;
    QAction* m_clear = nullptr;
};

} // namespace halbench::widgets
