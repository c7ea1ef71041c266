#pragma once

#include <QString>
#include <QWidget>

#include <optional>

namespace halbench::widgets {

/// How a live number is written; decimals never change while it runs, so that nothing jumps.
struct NumberFormat {
    int decimals = 3;
    QString unit; ///< as shown, e.g. "N·m"
    double min = -999.0;
    double max = 999.0; ///< with `min` decides the width
};

/// A live number: equal digits, right-aligned, unit in muted words; an old one is muted and underlined with
/// dots. Cheap to update: it is painted, not laid out.
class NumberLabel : public QWidget {
    Q_OBJECT
public:
    explicit NumberLabel(QWidget* parent = nullptr);

    void setFormat(const NumberFormat& format);
    const NumberFormat& format() const { return m_format; }

    void setValue(double value); ///< a value that is not finite shows as a dash
    void clear();
    void setStale(bool isStale);
    bool isStale() const { return m_isStale; }

    QString valueText() const; ///< without unit
    QString text() const;      ///< with unit

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    int numberWidth() const;
    int unitWidth() const;
    void describe();

    NumberFormat m_format;
    std::optional<double> m_value;
    bool m_isStale = false;
};

} // namespace halbench::widgets
