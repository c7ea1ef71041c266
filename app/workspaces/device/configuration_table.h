#pragma once

#include "app/documents/configuration_comparison.h"

#include <QTreeWidget>

#include <set>
#include <string>
#include <vector>

namespace halbench::app {

/// The rows of a configuration file beside the device: what differs can be ticked for restoring. Numbers are
/// in SI units, as in the file.
class ConfigurationTable : public QTreeWidget {
    Q_OBJECT

public:
    enum Column { NameColumn, DeviceColumn, FileColumn, StateColumn, DefaultColumn, UnitColumn };

    explicit ConfigurationTable(QWidget* parent = nullptr);

    /// Ticks what is proposed; with `keepTicks` rows that stay restorable keep the tick they have.
    void show(const ConfigurationComparison& comparison, bool keepTicks);
    /// Says beside each row what became of it, until that is no longer so or a show() without `keepTicks`.
    void showOutcomes(const std::vector<RowOutcome>& outcomes);
    /// Hides the rows that are the same.
    void setDifferencesOnly(bool isOnly);
    std::vector<std::string> ticked() const;
    /// Ticks or unticks the calibration that could be restored.
    void tickCalibration(bool isTicked);

Q_SIGNALS:
    void ticksChanged();
    /// What is to be said of the current row, whole; empty when its state says all.
    void reasonChanged(const QString& words);

private:
    QTreeWidgetItem* makeRow(const ComparedRow& row, bool isTicked);
    const RowOutcome* outcomeOf(const std::string& name) const;
    QString stateWords(const ComparedRow& row) const;
    QString reasonWords(const ComparedRow& row) const;
    void tellReason();
    void hideRows();

    std::vector<ComparedRow> m_rows; ///< one an item
    std::vector<RowOutcome> m_outcomes;
    bool m_isDifferencesOnly = true;
};

} // namespace halbench::app
