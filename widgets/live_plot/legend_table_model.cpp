#include "widgets/live_plot/legend_table_model.h"

#include "widgets/language/display_units.h"

#include <QFont>
#include <QGuiApplication>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr int SampleWidth = 18;
constexpr int SampleHeight = 8;
constexpr double SampleLine = 2.0;

/// An old value differs in more than its colour.
QFont slanted() {
    QFont font;
    font.setItalic(true);
    return font;
}

/// Before the decimal point; a number that is beyond all measure is cut.
int digitsOf(double value) {
    constexpr double Most = 1e12;
    const double size = std::min(std::abs(value), Most);
    return size < 1.0 ? 1 : 1 + static_cast<int>(std::floor(std::log10(size)));
}

std::optional<double> difference(const LegendNumbers& numbers) {
    return numbers.atA && numbers.atB ? std::optional(*numbers.atB - *numbers.atA) : std::nullopt;
}

} // namespace

QString curveWords(const PlotCurve& curve) {
    return curve.isRight ? LegendTableModel::tr("%1 (right)").arg(nameOf(curve)) : nameOf(curve);
}

void LegendTableModel::setCurves(const std::vector<HistoryCurve*>& curves) {
    beginResetModel();
    m_curves = curves;
    m_numbers.assign(curves.size(), {});
    m_digits = 0;
    endResetModel();
}

void LegendTableModel::setTheme(const Theme& theme) {
    m_theme = theme;
    if (!m_curves.empty()) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
    }
}

Qt::ItemFlags LegendTableModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
    return index.column() == Name ? usual | Qt::ItemIsEditable : usual;
}

/// The signal's own name is as no name.
bool LegendTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.column() != Name || role != Qt::EditRole) {
        return false;
    }
    const QString name = value.toString().simplified();
    Q_EMIT renamed(index.row(), name == curve(index.row()).label ? QString() : name);
    return true;
}

void LegendTableModel::setNumbers(const std::vector<LegendNumbers>& numbers) {
    if (numbers != m_numbers && numbers.size() == m_curves.size() && !m_curves.empty()) {
        m_numbers = numbers;
        for (const LegendNumbers& row : numbers) {
            for (const auto& value : {row.value, row.atA, row.atB, difference(row)}) {
                m_digits = std::max(m_digits, digitsOf(value.value_or(0.0)));
            }
        }
        Q_EMIT dataChanged(index(0, Value), index(rowCount() - 1, Difference));
    }
}

int LegendTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_curves.size());
}

int LegendTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Columns;
}

QString LegendTableModel::text(std::size_t row, int column) const {
    const PlotCurve& curve = m_curves[row]->curve();
    const LegendNumbers& numbers = m_numbers[row];
    switch (column) {
    case Name:
        return curveWords(curve);
    case Value:
        return fixedText(numbers.value, curve.decimals);
    case AtA:
        return fixedText(numbers.atA, curve.decimals);
    case AtB:
        return fixedText(numbers.atB, curve.decimals);
    case Difference:
        return fixedText(difference(numbers), curve.decimals);
    default:
        return curve.unit;
    }
}

QString LegendTableModel::widestText(int row, Column column) const {
    if (column == Name || column == Unit) {
        return text(static_cast<std::size_t>(row), column);
    }
    const int decimals = m_curves[static_cast<std::size_t>(row)]->curve().decimals;
    const int usual = decimals < 3 ? 4 : 3; // fine scales measure small quantities
    const double eights = std::floor(std::pow(10.0, std::max(usual, m_digits)) * 8.0 / 9.0);
    return fixedText(-eights, decimals);
}

QString LegendTableModel::describe(std::size_t row) const {
    const QString state = isStale(row) ? QStringLiteral("\n") + m_numbers[row].stale : QString();
    return tr("%1: %2 %3%4")
        .arg(curveWords(m_curves[row]->curve()), text(row, Value), m_curves[row]->curve().unit, state);
}

QVariant LegendTableModel::colour(std::size_t row, int column) const {
    if (!m_curves[row]->isVisible()) {
        return m_theme.disabled;
    }
    if (column == Unit || (column == Value && isStale(row))) {
        return m_theme.muted;
    }
    return m_theme.text;
}

QPixmap LegendTableModel::lineSample(std::size_t row) const {
    const double ratio = qGuiApp->devicePixelRatio();
    QPixmap pixmap(QSize(SampleWidth, SampleHeight) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const HistoryCurve& curve = *m_curves[row];
    painter.setPen(
        curvePen(curve.isVisible() ? curve.colour() : m_theme.disabled, curve.pattern(), SampleLine));
    painter.drawLine(QPointF(0.0, 0.5 * SampleHeight), QPointF(SampleWidth, 0.5 * SampleHeight));
    return pixmap;
}

QVariant LegendTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const auto row = static_cast<std::size_t>(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::EditRole:
        return index.column() == Name ? QVariant(nameOf(m_curves[row]->curve())) : QVariant();
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return index.column() == Name || (index.column() == Value && isStale(row)) ? QVariant(describe(row))
                                                                                   : QVariant();
    case Qt::DecorationRole:
        return index.column() == Name ? QVariant(lineSample(row)) : QVariant();
    case Qt::ForegroundRole:
        return colour(row, index.column());
    case Qt::FontRole:
        return index.column() == Value && isStale(row) ? QVariant(slanted()) : QVariant();
    case Qt::TextAlignmentRole:
        return static_cast<int>(
            Qt::AlignVCenter |
            (index.column() >= Value && index.column() <= Difference ? Qt::AlignRight : Qt::AlignLeft));
    default:
        return {};
    }
}

QVariant LegendTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case Name:
        return tr("Signal");
    case Value:
        return tr("Now");
    case AtA:
        return QStringLiteral("A");
    case AtB:
        return QStringLiteral("B");
    case Difference:
        return tr("B − A");
    default:
        return tr("Unit");
    }
}

} // namespace halbench::widgets
