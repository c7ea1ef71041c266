#pragma once

#include <QString>

#include <optional>

namespace halbench::widgets {

/// Decimals of a moment in seconds, so that what is apart on the screen is apart in digits too: a thousandth
/// of the stretch that is shown, and a tenth of the samples' period, whichever is finer; four at least (0.1
/// ms), nine at most (a double has no more at the times of a day). Without samples the stretch alone.
int timeDecimals(double span_s, std::optional<double> period_s);

/// "0.000123456": a stretch of time without exponent, with the decimals of the moments it lies between, but
/// five significant digits at least, so that a short one says as much as a long one.
QString timeDistanceText(double distance_s, int decimals);

/// As many decimals as were typed, in either notation; none where the text is no number.
int typedDecimals(const QString& text);

} // namespace halbench::widgets
