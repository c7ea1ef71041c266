#pragma once

#include "widgets/live_plot/history_curve.h"
#include "widgets/live_plot/plot_marks.h"
#include "widgets/theme/theme.h"

#include <QAbstractTableModel>

#include <optional>
#include <vector>

namespace halbench::widgets {

/// Its label, with the axis where that is the right one.
QString curveWords(const PlotCurve& curve);

/// The numbers of one curve beside its plot, in the unit shown.
struct LegendNumbers {
    std::optional<double> value;
    std::optional<double> atA;
    std::optional<double> atB;
    QString stale; ///< since when `value` is old, in words; empty: it is not
    bool operator==(const LegendNumbers&) const = default;
};

/// One row a curve: line sample and name, live value, values at the cursors and their difference, unit.
class LegendTableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Value, AtA, AtB, Difference, Unit, Columns };

    explicit LegendTableModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// The curves are not owned and must outlive the model's next setCurves.
    void setCurves(const std::vector<HistoryCurve*>& curves);
    void setTheme(const Theme& theme);
    void setNumbers(const std::vector<LegendNumbers>& numbers);
    /// The widest text a column can be expected to show, for its width.
    QString widestText(int row, Column column) const;
    /// Before the decimal point; when it grows, columns ask for more room.
    int digits() const { return m_digits; }
    bool isShown(int row) const { return m_curves[static_cast<std::size_t>(row)]->isVisible(); }
    const PlotCurve& curve(int row) const { return item(row).curve(); }
    const HistoryCurve& item(int row) const { return *m_curves[static_cast<std::size_t>(row)]; }
    bool isRight(int row) const { return m_curves[static_cast<std::size_t>(row)]->curve().isRight; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

Q_SIGNALS:
    void renamed(int row, const QString& name); ///< empty: as the signal

private:
    QString text(std::size_t row, int column) const;
    QString describe(std::size_t row) const;
    QVariant colour(std::size_t row, int column) const;
    bool isStale(std::size_t row) const { return !m_numbers[row].stale.isEmpty(); }
    QPixmap lineSample(std::size_t row) const;

    std::vector<HistoryCurve*> m_curves;
    std::vector<LegendNumbers> m_numbers;
    Theme m_theme;
    int m_digits = 0; ///< before the decimal point, of the largest number so far: widths only grow
};

} // namespace halbench::widgets
