#include "widgets/figure/figure_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace halbench::widgets {
namespace {

struct Column {
    std::string title;
    std::vector<double> values;
};

std::string titleOf(const std::string& curve, const Axis& axis, const std::string& edge = {}) {
    std::string title = curve.empty() ? axis.quantity : curve + " " + axis.quantity;
    title += edge.empty() ? "" : " " + edge;
    return axis.unit.empty() ? title : fmt::format("{} [{}]", title, axis.unit);
}

/// As the comma separated form wants words with commas and quotes.
std::string quoted(const std::string& words) {
    if (words.find_first_of(",\"\n") == std::string::npos) {
        return words;
    }
    std::string text = "\"";
    for (const char letter : words) {
        text += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    }
    return text + "\"";
}

/// The curves of a panel as columns; horizontal values that stand there already are not written again.
class Table {
public:
    explicit Table(const Figure& figure) : m_figure(figure) {}

    void add(const Panel& panel, const Curve& curve) {
        if (curve.style == CurveStyle::Band) {
            addBand(panel, curve);
            return;
        }
        addAcross(curve.label, m_figure.x, curve.x);
        if (m_figure.parameter && curve.parameter.size() == curve.x.size()) {
            addAcross(curve.label, *m_figure.parameter, curve.parameter);
        }
        const Axis& axis = curve.isRight && panel.right ? *panel.right : panel.y;
        m_columns.push_back({titleOf(curve.label, axis), curve.y});
    }

    std::string text() const {
        std::string text;
        std::size_t rows = 0;
        for (const Column& column : m_columns) {
            text += (&column == &m_columns.front() ? "" : ",") + quoted(column.title);
            rows = std::max(rows, column.values.size());
        }
        text += '\n';
        for (std::size_t row = 0; row < rows; ++row) {
            for (const Column& column : m_columns) {
                text += &column == &m_columns.front() ? "" : ",";
                if (row < column.values.size() && std::isfinite(column.values[row])) {
                    text += fmt::format("{}", column.values[row]);
                }
            }
            text += '\n';
        }
        return text;
    }

private:
    /// The outline goes along its upper edge and back along the lower one.
    void addBand(const Panel& panel, const Curve& curve) {
        const std::size_t half = curve.x.size() / 2;
        const auto middle = static_cast<std::ptrdiff_t>(half);
        addAcross(curve.label, m_figure.x, {curve.x.begin(), curve.x.begin() + middle});
        const std::vector<double> upper(curve.y.begin(), curve.y.begin() + middle);
        const std::vector<double> lower(curve.y.rbegin(), curve.y.rbegin() + middle);
        m_columns.push_back({titleOf(curve.label, panel.y, "p5"), lower});
        m_columns.push_back({titleOf(curve.label, panel.y, "p95"), upper});
    }

    void addAcross(const std::string& curve, const Axis& axis, const std::vector<double>& values) {
        const bool isThere = std::any_of(m_across.begin(), m_across.end(), [&](std::size_t column) {
            return m_columns[column].values == values;
        });
        if (!isThere) {
            const std::string plain = titleOf({}, axis);
            const bool isFirst = std::none_of(m_columns.begin(), m_columns.end(),
                                              [&](const Column& column) { return column.title == plain; });
            m_across.push_back(m_columns.size());
            m_columns.push_back({isFirst ? plain : titleOf(curve, axis), values});
        }
    }

    const Figure& m_figure;
    std::vector<Column> m_columns;
    std::vector<std::size_t> m_across; ///< columns of horizontal values
};

} // namespace

std::string figureTable(const Figure& figure) {
    Table table(figure);
    for (const Panel& panel : figure.panels) {
        for (const Curve& curve : panel.curves) {
            table.add(panel, curve);
        }
    }
    return table.text();
}

} // namespace halbench::widgets
