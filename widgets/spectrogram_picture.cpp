#include "widgets/spectrogram_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::widgets {
namespace {

constexpr double MostDecades = 6.0;
constexpr double FloorShare = 0.1; ///< of the values lies below the colours' lower end
constexpr int RoundSteps = 5;

/// Those of `middles` in [low, high).
std::pair<std::size_t, std::size_t> inside(const std::vector<double>& middles, double low, double high) {
    const auto first = std::lower_bound(middles.begin(), middles.end(), low);
    const auto last = std::lower_bound(first, middles.end(), high);
    return {static_cast<std::size_t>(first - middles.begin()),
            static_cast<std::size_t>(last - middles.begin())};
}

/// The nearest within half a step.
std::optional<std::size_t> nearest(const std::vector<double>& middles, double at, double step) {
    const auto above = std::lower_bound(middles.begin(), middles.end(), at);
    const bool isBelowNearer =
        above == middles.end() || (above != middles.begin() && at - *(above - 1) < *above - at);
    const auto found = isBelowNearer ? above - 1 : above;
    return std::abs(*found - at) <= 0.5 * step
               ? std::optional(static_cast<std::size_t>(found - middles.begin()))
               : std::nullopt;
}

/// What a pixel is drawn from: the cells with their middle in it, else the one that it lies in.
std::pair<std::size_t, std::size_t> cellsOf(const std::vector<double>& middles, double at, double pixel,
                                            double step) {
    const auto [first, last] = inside(middles, at - 0.5 * pixel, at + 0.5 * pixel);
    if (first < last) {
        return {first, last};
    }
    const std::optional<std::size_t> one = nearest(middles, at, step);
    return one ? std::pair(*one, *one + 1) : std::pair(std::size_t{0}, std::size_t{0});
}

ValueRange decades(std::vector<double> positive) {
    if (positive.empty()) {
        return {0.1, 1.0};
    }
    const double high = std::ceil(std::log10(*std::max_element(positive.begin(), positive.end())));
    const auto floor =
        positive.begin() + static_cast<std::ptrdiff_t>(FloorShare * static_cast<double>(positive.size()));
    std::nth_element(positive.begin(), floor, positive.end());
    const double low = std::clamp(std::floor(std::log10(*floor)), high - MostDecades, high - 1.0);
    return {std::pow(10.0, low), std::pow(10.0, high)};
}

} // namespace

double SpectrogramPicture::columnStep_s() const {
    double step_s = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < time_s.size(); ++i) {
        step_s = std::min(step_s, time_s[i] - time_s[i - 1]);
    }
    return std::isfinite(step_s) ? step_s : 1.0;
}

double SpectrogramPicture::lineStep_Hz() const {
    return frequency_Hz.size() > 1 ? frequency_Hz[1] - frequency_Hz[0] : 1.0;
}

std::optional<std::size_t> SpectrogramPicture::columnAt(double at_s) const {
    return isEmpty() ? std::nullopt : nearest(time_s, at_s, columnStep_s());
}

std::optional<std::size_t> SpectrogramPicture::lineAt(double at_Hz) const {
    return isEmpty() ? std::nullopt : nearest(frequency_Hz, at_Hz, lineStep_Hz());
}

SpectrogramCell highestCell(const SpectrogramPicture& picture) {
    const auto highest = std::max_element(picture.values.begin(), picture.values.end());
    const auto place = static_cast<std::size_t>(highest - picture.values.begin());
    const std::size_t lines = picture.frequency_Hz.size();
    return picture.isEmpty() ? SpectrogramCell{} : SpectrogramCell{place / lines, place % lines};
}

ValueRange colourRange(const SpectrogramPicture& picture) {
    std::vector<double> positive;
    std::copy_if(picture.values.begin(), picture.values.end(), std::back_inserter(positive),
                 [](double value) { return value > 0.0; });
    if (picture.isLogarithmic) {
        return decades(std::move(positive));
    }
    if (positive.empty()) {
        return {0.0, 1.0};
    }
    const double high = *std::max_element(positive.begin(), positive.end());
    const double step = niceStep(high, RoundSteps);
    return {0.0, step * std::ceil(high / step)};
}

SpectrogramRaster::SpectrogramRaster(std::shared_ptr<const SpectrogramPicture> picture)
    : m_picture(std::move(picture)) {
    const double column_s = m_picture->columnStep_s();
    const double line_Hz = m_picture->lineStep_Hz();
    setInterval(Qt::XAxis,
                {m_picture->time_s.front() - 0.5 * column_s, m_picture->time_s.back() + 0.5 * column_s});
    setInterval(Qt::YAxis, {m_picture->frequency_Hz.front() - 0.5 * line_Hz,
                            m_picture->frequency_Hz.back() + 0.5 * line_Hz});
    const ValueRange range = colourRange(*m_picture);
    setInterval(Qt::ZAxis, {range.low, range.high});
    m_column_s = column_s;
    m_line_Hz = line_Hz;
}

void SpectrogramRaster::initRaster(const QRectF& area, const QSize& raster) {
    m_pixel_s = area.width() / std::max(1, raster.width());
    m_pixel_Hz = area.height() / std::max(1, raster.height());
}

double SpectrogramRaster::value(double time_s, double frequency_Hz) const {
    const auto [firstColumn, endColumn] = cellsOf(m_picture->time_s, time_s, m_pixel_s, m_column_s);
    const auto [firstLine, endLine] = cellsOf(m_picture->frequency_Hz, frequency_Hz, m_pixel_Hz, m_line_Hz);
    double largest = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t column = firstColumn; column < endColumn; ++column) {
        for (std::size_t line = firstLine; line < endLine; ++line) {
            largest = std::fmax(largest, m_picture->value(column, line));
        }
    }
    return largest;
}

} // namespace halbench::widgets
