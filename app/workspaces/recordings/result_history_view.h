#pragma once

#include "app/documents/result_history.h"

#include <QTableWidget>

#include <vector>

namespace halbench::app {

/// Identified values over time with their intervals and their drift against the first of the same device.
class ResultHistoryView : public QTableWidget {
    Q_OBJECT

public:
    explicit ResultHistoryView(QWidget* parent = nullptr);
    void setRows(std::vector<ResultRow> rows);

private:
    void fillRow(int row);

    std::vector<ResultRow> m_rows;
};

} // namespace halbench::app
