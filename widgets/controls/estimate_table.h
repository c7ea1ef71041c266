#pragma once

#include <QTableWidget>

#include <optional>
#include <vector>

namespace halbench::widgets {

/// One quantity of an estimate as it is shown: never without its interval.
struct EstimateRow {
    QString name;
    std::optional<double> value;
    std::optional<double> low95;
    std::optional<double> high95;
    QString unit;
    QString source;
    QString remark; ///< tooltip: what would supply a value that is missing, or what it means

    bool operator==(const EstimateRow&) const = default;
};

/// Value +- half of the 95 % interval, with so many digits that the half shows two; read only, copied with
/// Ctrl+C as text.
class EstimateTable : public QTableWidget {
    Q_OBJECT
public:
    explicit EstimateTable(QWidget* parent = nullptr);

    void setRows(const std::vector<EstimateRow>& rows);
    /// Of the last column, where it holds numbers and not where the values are from.
    void setLastTitle(const QString& title);
    /// The rows as lines of tab-separated text, with the header.
    QString text() const;

    /// At which no name takes two lines.
    int neededWidth() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refreshWords();
    bool isNumber(int column) const;

    QString m_lastTitle;             ///< empty: the source
    std::vector<EstimateRow> m_rows; ///< as shown: values of the device come again and again
};

/// Value and half-width in the user's notation: {"1.230", "0.021"}.
struct EstimateText {
    QString value;
    QString half;
};
EstimateText estimateText(double value, std::optional<double> half);

} // namespace halbench::widgets
