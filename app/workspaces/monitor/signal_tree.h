#pragma once

#include "app/workbench/display_quantity.h"
#include "control/base/parameter_spec.h"
#include "control/history/sample_history.h"

#include <QStringList>
#include <QTreeWidget>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace halbench::app {

/// The device's signals by quantity with their live values. A tick, or Enter, plots a signal; dragging
/// carries names to a plot (widgets/live_plot/live_plot_spec.h).
class SignalTree : public QTreeWidget {
    Q_OBJECT

public:
    enum Column { NameColumn, ValueColumn, UnitColumn };

    explicit SignalTree(QWidget* parent = nullptr);

    void setSignals(const std::vector<SignalSpec>& specs, const DisplayUnits& units);
    /// Which are plotted; sends nothing.
    void setPlotted(const std::set<std::string>& names);
    /// The latest values. Old ones are slanted, muted and say since when; `stale`: words when all are old.
    void showValues(const control::SampleHistory& history, const QString& stale);

Q_SIGNALS:
    void plotRequested(const QString& name, bool isPlotted);

protected:
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QList<QTreeWidgetItem*> items) const override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Entry {
        QTreeWidgetItem* item = nullptr;
        double factor = 1.0;
        int decimals = 3;
        std::vector<std::string> choices;
        QString stale = {}; ///< as marked
    };

    void inkUnits();
    QTreeWidgetItem* groupFor(const QString& title);
    void toggle(QTreeWidgetItem* item);
    void inkValue(const Entry& entry);
    void markStale(Entry& entry, const QString& words);
    QString valueText(const Entry& entry, double value) const;

    std::map<std::string, Entry> m_entries;
};

} // namespace halbench::app
