#pragma once

#include "widgets/live_plot/axes/value_range.h"

#include <QString>
#include <qwt_raster_data.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace halbench::widgets {

/// Spectra of a signal beside each other, in the units shown.
struct SpectrogramPicture {
    QString title;    ///< also the accessible name of the picture
    QString quantity; ///< of the values
    QString unit;
    bool isLogarithmic = true; ///< the colours
    double decade_dB = 0.0;    ///< how many dB ten times as much is, where the colours' scale says dB
    bool isFrequencyLogarithmic = false;
    std::optional<double> lowest_Hz = {}; ///< ends of what is shown; none: of the lines
    std::optional<double> highest_Hz = {};
    std::optional<double> darkest = {}; ///< ends of the colours; none: of the values
    std::optional<double> brightest = {};
    std::vector<double> time_s;       ///< middles of the columns, rising; farther apart over a gap
    std::vector<double> frequency_Hz; ///< lines in equal steps
    std::vector<double> values;       ///< a column's lines beside each other; not negative

    bool isEmpty() const { return time_s.empty() || frequency_Hz.empty(); }
    double value(std::size_t column, std::size_t line) const {
        return values[column * frequency_Hz.size() + line];
    }
    double columnStep_s() const; ///< the smallest between neighbours; of one column, 1
    double lineStep_Hz() const;
    /// Where a value was found, nothing inside a gap and beyond the ends.
    std::optional<std::size_t> columnAt(double time_s) const;
    std::optional<std::size_t> lineAt(double frequency_Hz) const;
};

/// The frequencies that are shown: half a line beyond the outermost ones, or to the ends asked for. Ends that
/// hold no line between them are none; a logarithmic axis begins above zero.
ValueRange frequencyRange(const SpectrogramPicture& picture);
/// First and last of the lines that are shown.
std::pair<std::size_t, std::size_t> shownLines(const SpectrogramPicture& picture);

/// The column and line of the largest value that is shown.
struct SpectrogramCell {
    std::size_t column = 0;
    std::size_t line = 0;
    bool operator==(const SpectrogramCell&) const = default;
};
SpectrogramCell highestCell(const SpectrogramPicture& picture);

/// What the colours reach over: logarithmic whole decades around the largest value and what nine tenths of
/// the others exceed, at most six; else from 0 to the largest value, rounded. Of the values that are shown;
/// where an end was asked for, there. Ends that leave nothing between them are none.
ValueRange colourRange(const SpectrogramPicture& picture);

/// The picture for QwtPlotSpectrogram. A pixel shows the largest of the values in it, so that no line and no
/// moment is lost where there are more of them than pixels; inside a gap it shows nothing (NaN).
class SpectrogramRaster : public QwtRasterData {
public:
    explicit SpectrogramRaster(std::shared_ptr<const SpectrogramPicture> picture);

    void initRaster(const QRectF& area, const QSize& raster) override;
    double value(double time_s, double frequency_Hz) const override;

private:
    std::shared_ptr<const SpectrogramPicture> m_picture;
    double m_column_s = 1.0; ///< steps of the picture
    double m_line_Hz = 1.0;
    double m_pixel_s = 0.0;
    double m_pixel_Hz = 0.0;
    double m_pixel_ratio = 1.0; ///< of a pixel's ends where the axis is logarithmic
};

} // namespace halbench::widgets
