#pragma once

#include "app/workspaces/recordings/import_text.h"

#include <QTableWidget>

#include <optional>
#include <vector>

namespace halbench::app {

/// The first rows of a table as they would be read. Above them stand the name and the unit of each column,
/// which the user may say otherwise and take back again.
class ImportTable : public QTableWidget {
    Q_OBJECT

public:
    explicit ImportTable(QWidget* parent = nullptr);

    /// Other columns come: nothing is said of them.
    void forget();
    void showLook(const TableLook& look);
    /// It cannot be read as it is said: what was said stays, so that it can be mended.
    void showUnread();
    /// Adds what the user said of the columns.
    void addTo(devices::CsvImportRequest& request) const;
    /// What answers a question about a unit.
    void take(const devices::CsvQuestion::Answer& answer);

Q_SIGNALS:
    void changed(); ///< by the user

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Said {
        QString name; ///< empty: as found
        QString unit;
    };
    void show(const ImportPreview& preview, bool isRead);
    void showColumn(std::size_t index);
    QTableWidgetItem& showCell(int row, int column, const QString& text, Qt::Alignment alignment);
    void showRowTitles();
    int firstRow() const;
    void onItem(const QTableWidgetItem& item);

    std::vector<devices::CsvColumn> m_columns; ///< when it was last read
    std::optional<std::size_t> m_time;
    std::vector<Said> m_said; ///< of each column
    int m_shift = 0;          ///< columns before that of the table: the time that is counted
};

} // namespace halbench::app
