#include "widgets/spectrogram/spectrogram_picture.h"

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
std::pair<std::size_t, std::size_t> cellsOf(const std::vector<double>& middles, double at, ValueRange pixel,
                                            double step) {
    const auto [first, last] = inside(middles, pixel.low, pixel.high);
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

ValueRange frequencyRange(const SpectrogramPicture& picture) {
    const double half_Hz = 0.5 * picture.lineStep_Hz();
    ValueRange all{picture.frequency_Hz.front() - half_Hz, picture.frequency_Hz.back() + half_Hz};
    if (picture.isFrequencyLogarithmic && all.high > half_Hz) {
        all.low = std::max(all.low, half_Hz); // without the line at zero
    }
    const ValueRange asked{std::max(all.low, picture.lowest_Hz.value_or(all.low)),
                           std::min(all.high, picture.highest_Hz.value_or(all.high))};
    const auto [first, end] = inside(picture.frequency_Hz, asked.low, std::nextafter(asked.high, all.high));
    return first < end ? asked : all;
}

std::pair<std::size_t, std::size_t> shownLines(const SpectrogramPicture& picture) {
    const ValueRange range = frequencyRange(picture);
    const auto [first, end] = inside(picture.frequency_Hz, range.low, std::nextafter(range.high, HUGE_VAL));
    return first < end ? std::pair(first, end - 1)
                       : std::pair(std::size_t{0}, picture.frequency_Hz.size() - 1);
}

SpectrogramCell highestCell(const SpectrogramPicture& picture) {
    SpectrogramCell highest;
    if (picture.isEmpty()) {
        return highest;
    }
    const auto [first, last] = shownLines(picture);
    highest.line = first;
    for (std::size_t column = 0; column < picture.time_s.size(); ++column) {
        for (std::size_t line = first; line <= last; ++line) {
            if (picture.value(column, line) > picture.value(highest.column, highest.line)) {
                highest = {column, line};
            }
        }
    }
    return highest;
}

namespace {

std::vector<double> positiveValues(const SpectrogramPicture& picture) {
    std::vector<double> positive;
    const auto [first, last] =
        picture.isEmpty() ? std::pair<std::size_t, std::size_t>() : shownLines(picture);
    for (std::size_t column = 0; column < picture.time_s.size(); ++column) {
        for (std::size_t line = first; line <= last; ++line) {
            if (picture.value(column, line) > 0.0) {
                positive.push_back(picture.value(column, line));
            }
        }
    }
    return positive;
}

ValueRange fittingColours(const SpectrogramPicture& picture) {
    std::vector<double> positive = positiveValues(picture);
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

} // namespace

ValueRange colourRange(const SpectrogramPicture& picture) {
    const ValueRange fitting = fittingColours(picture);
    const ValueRange asked{picture.darkest.value_or(fitting.low), picture.brightest.value_or(fitting.high)};
    const bool isPossible = asked.low < asked.high && (!picture.isLogarithmic || asked.low > 0.0);
    return isPossible ? asked : fitting;
}

SpectrogramRaster::SpectrogramRaster(std::shared_ptr<const SpectrogramPicture> picture)
    : m_picture(std::move(picture)) {
    const double column_s = m_picture->columnStep_s();
    const double line_Hz = m_picture->lineStep_Hz();
    setInterval(Qt::XAxis,
                {m_picture->time_s.front() - 0.5 * column_s, m_picture->time_s.back() + 0.5 * column_s});
    const ValueRange shown = frequencyRange(*m_picture);
    setInterval(Qt::YAxis, {shown.low, shown.high});
    const ValueRange range = colourRange(*m_picture);
    setInterval(Qt::ZAxis, {range.low, range.high});
    m_column_s = column_s;
    m_line_Hz = line_Hz;
}

void SpectrogramRaster::initRaster(const QRectF& area, const QSize& raster) {
    m_pixel_s = area.width() / std::max(1, raster.width());
    const double pixels = std::max(1, raster.height());
    m_pixel_Hz = area.height() / pixels;
    const bool hasRatio = m_picture->isFrequencyLogarithmic && area.top() > 0.0;
    m_pixel_ratio = hasRatio ? std::pow(area.bottom() / area.top(), 0.5 / pixels) : 1.0;
}

double SpectrogramRaster::value(double time_s, double frequency_Hz) const {
    const ValueRange moment{time_s - 0.5 * m_pixel_s, time_s + 0.5 * m_pixel_s};
    const ValueRange band =
        m_picture->isFrequencyLogarithmic
            ? ValueRange{frequency_Hz / m_pixel_ratio, frequency_Hz * m_pixel_ratio}
            : ValueRange{frequency_Hz - 0.5 * m_pixel_Hz, frequency_Hz + 0.5 * m_pixel_Hz};
    const auto [firstColumn, endColumn] = cellsOf(m_picture->time_s, time_s, moment, m_column_s);
    const auto [firstLine, endLine] = cellsOf(m_picture->frequency_Hz, frequency_Hz, band, m_line_Hz);
    double largest = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t column = firstColumn; column < endColumn; ++column) {
        for (std::size_t line = firstLine; line < endLine; ++line) {
            largest = std::fmax(largest, m_picture->value(column, line));
        }
    }
    return largest;
}

} // namespace halbench::widgets
