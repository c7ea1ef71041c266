#pragma once

#include <QTableWidget>

#include <optional>
#include <vector>

class QAction;

namespace halbench::widgets {

/// What one curve did in a stretch of time, in the unit shown. Without a value there are no numbers.
struct StatisticsRow {
    QString name;
    QString unit;
    int decimals = 3;
    double min = 0.0;
    double max = 0.0;
    double mean = 0.0;
    double rms = 0.0;
    double deviation = 0.0;
    std::optional<double> slope; ///< per second, from cursor A to B
    quint64 count = 0;           ///< of values
    quint64 gaps = 0;
    bool isKnown = true; ///< false: nothing of it can be told yet
};

/// Statistics of curves, a row each; read only, copied with Ctrl+C or from its menu as tab-separated text.
/// Long names give way to the numbers, and a number is whole or three dots.
class StatisticsTable : public QTableWidget {
    Q_OBJECT
public:
    explicit StatisticsTable(QWidget* parent = nullptr);

    /// What the numbers are of stands above the names.
    void setStretch(const QString& words);
    void setRows(const std::vector<StatisticsRow>& rows);
    QString text() const;
    /// Of as many whole rows as find room in that height, of the least ones at least.
    int heightWithin(int room_px) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void copy();
    void refreshWords();
    void fitColumns(bool isAnew);
    QSize sizeOf(int rows) const;
    int leastRows() const;
    void put(int row, int column, const QString& text);

    QAction* m_copy = nullptr;
    QString m_stretch;
    std::vector<int> m_needed_px; ///< by each column so far
    bool m_isScrolled = false;    ///< sideways
};

} // namespace halbench::widgets
