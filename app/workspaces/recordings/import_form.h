#pragma once

#include "devices/formats/csv_import.h"

#include <QWidget>

#include <optional>

class QComboBox;

namespace halbench::widgets {
class QuantityEdit;
}

namespace halbench::app {

class FieldGrid;

/// How a table of another program is to be read: what was found, which the user may say otherwise
/// (resources/help/monitor.md, "Import").
class ImportForm : public QWidget {
    Q_OBJECT

public:
    explicit ImportForm(QWidget* parent = nullptr);

    /// Another table: nothing is said of it.
    void reset();
    void showPlan(const devices::CsvPlan& plan);
    devices::CsvImportRequest request() const;
    /// What answers a question; that of a unit is not asked here.
    void take(const devices::CsvQuestion::Answer& answer);
    /// What is begun and not said whole; empty: nothing.
    QString obstacle() const;

Q_SIGNALS:
    void changed();  ///< by the user
    void reshaped(); ///< before it: the columns become others

private:
    QComboBox* addChoice(FieldGrid& grid, const QString& title, const QString& toolTip,
                         const std::vector<std::pair<QString, QString>>& choices);
    void showColumns(const devices::CsvPlan& plan);
    void onTime();

    QComboBox* m_separator = nullptr;
    QComboBox* m_decimal = nullptr;
    QComboBox* m_header = nullptr;
    QComboBox* m_time = nullptr;
    widgets::QuantityEdit* m_rate = nullptr;
};

} // namespace halbench::app
