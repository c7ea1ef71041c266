#pragma once

#include "devices/open/simulation_options.h"

#include <QDialog>

class QLineEdit;
class QPushButton;
class QTableWidget;
class QTableWidgetItem;

namespace halbench::widgets {
class MessageBar;
}

namespace halbench::app {

/// Options of a simulated device as a table: value, unit, standard and range of each key of its address.
/// Thread: GUI.
class SimulationOptionsDialog : public QDialog {
    Q_OBJECT
public:
    explicit SimulationOptionsDialog(devices::SimulationOptions options, QWidget* parent = nullptr);

    /// The address with the values that were entered.
    QString address() const;

private:
    enum Column { Key, Value, Unit, Standard, Range, Meaning, ColumnCount };

    void buildTable();
    void fillRow(int row, const devices::SimulationOptions::Row& option);
    void addChoices(int row, const devices::SimulationOptions::Row& option);
    void setOption(int row, const QString& value);
    void onEdited(QTableWidgetItem* item);
    void clearAll();
    void filterRows(const QString& words);
    void refresh();

    devices::SimulationOptions m_options;
    QLineEdit* m_filter = nullptr;
    QTableWidget* m_table = nullptr;
    widgets::MessageBar* m_message = nullptr;
    QPushButton* m_use = nullptr;
};

} // namespace halbench::app
