#include "widgets/theme/sequence_colours.h"

#include "control/base/assert.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <vector>

// The macro declares a function of the global namespace.
static void registerSequences() {
    Q_INIT_RESOURCE(themes);
}

namespace halbench::widgets {
namespace {

std::vector<QColor> readStops() {
    registerSequences();
    QFile file(QStringLiteral(":/themes/sequence.json"));
    HB_ASSERT(file.open(QIODevice::ReadOnly));
    std::vector<QColor> stops;
    for (const QJsonValue value :
         QJsonDocument::fromJson(file.readAll()).object().value(QStringLiteral("colours")).toArray()) {
        stops.emplace_back(value.toString());
    }
    HB_ASSERT(stops.size() > 2);
    return stops;
}

const std::vector<QColor>& colourStops() {
    static const std::vector<QColor> stops = readStops();
    return stops;
}

} // namespace

SequenceColours::SequenceColours(bool isLogarithmic)
    : QwtLinearColorMap(colourStops().front(), colourStops().back()), m_isLogarithmic(isLogarithmic) {
    const std::vector<QColor>& stops = colourStops();
    for (std::size_t i = 1; i + 1 < stops.size(); ++i) {
        addColorStop(static_cast<double>(i) / static_cast<double>(stops.size() - 1), stops[i]);
    }
}

QRgb SequenceColours::rgb(const QwtInterval& interval, double value) const {
    return m_isLogarithmic
               ? QwtLinearColorMap::rgb({std::log10(interval.minValue()), std::log10(interval.maxValue())},
                                        std::log10(value))
               : QwtLinearColorMap::rgb(interval, value);
}

} // namespace halbench::widgets
