#pragma once

#include "control/base/result.h"
#include "control/signals/window.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halbench::control {

/// What a line of a spectrum says of a signal in ampere. A steady sine is read from the first two, whatever
/// the segment's length; noise from the last two.
enum class SpectrumScale {
    Peak,       ///< amplitude of the sine, A
    Rms,        ///< its root mean square, A
    Density,    ///< power spectral density, A^2/Hz
    RootDensity ///< its root, A/sqrt(Hz)
};

struct SpectrumConfig {
    SpectrumScale scale = SpectrumScale::Peak;
    WindowShape window = WindowShape::Hann;
    /// Taken to the nearest fast length. Nothing: amplitudes take the longest stretch whole, densities make
    /// at least eight half overlapping segments of it.
    std::optional<double> segment_s;
    double overlap_ratio = 0.5; ///< of neighbouring segments, 0 to 0.95
    bool removesMean = true;    ///< of each segment
    double confidence_ratio = 0.95;
};

/// A signal on its time axis; the values are NaN where there is none.
struct SignalView {
    std::span<const double> time_s;
    std::span<const double> values;
    std::string unit; ///< SI symbol, empty for none
};

/// Asked now and then; its error ends the work.
using AbortCheck = std::function<Result<void>()>;

/// One-sided: the lines 0, 1/S, 2/S ... up to half the rate carry all the power.
struct Spectrum {
    SpectrumConfig config; ///< as asked
    std::string unit;      ///< of the values: see spectrumUnit()
    std::vector<double> frequency_Hz;
    std::vector<double> values;
    std::vector<double> low, high; ///< interval of what the averages estimate
    double rms = 0.0;              ///< root of the density's integral, in the signal's unit
    double period_s = 0.0;
    std::size_t segmentRows = 0;
    std::size_t segments = 0;
    double equivalentAverages = 0.0; ///< independent segments that would average as well
    std::size_t gaps = 0;
    std::size_t missingValues = 0;
    std::size_t usedRows = 0;

    double segment_s() const { return static_cast<double>(segmentRows) * period_s; }
    double lineDistance_Hz() const { return 1.0 / segment_s(); }
    double noiseBandwidth_Hz() const {
        return figuresOf(config.window).noiseBandwidth_lines * lineDistance_Hz();
    }
};

/// Welch's (1967) averaged periodogram: with the window's weights w and the segments' transforms X_k
///
///     density_k = 2 T mean |X_k|^2 / sum w^2,    rms_k^2 = 2 mean |X_k|^2 / (sum w)^2,    peak_k = sqrt(2)
///     rms_k
///
/// (without the 2 at zero and half the rate, where peak = rms). No segment reaches across a gap or a missing
/// value. The interval is that of a noise: nu values / chi^2 with nu = 2 K_e, one degree per average at zero
/// and half the rate; for a steady sine it is too wide. K segments of an overlap count as
///
///     K_e = K^2 / (K + 2 sum_m (K - m) rho_m),    rho_m = (sum_n w_n w_(n+mD) / sum w^2)^2
///
/// averages (Percival and Walden 1993, eq. 292b), D rows from one to the next, summed over the stretches.
/// Errors: OutOfRange, NotFinite (configuration); of findUniformSegments(); Refused (no stretch is as long as
/// a segment, or the rate drifts); that of `checkAbort`.
Result<Spectrum> spectrum(const SignalView& signal, const SpectrumConfig& config,
                          const AbortCheck& checkAbort = {});

/// Symbol of a spectrum's values: "A", "A^2/Hz", "A/sqrt(Hz)"; "(rad/s)^2/Hz". A temperature in degC becomes
/// K, which its differences are in.
std::string spectrumUnit(const std::string& unit, SpectrumScale scale);

/// Lines higher than all others within the window's main lobe, the highest first. None at zero and half the
/// rate, and none below a millionth of the highest amplitude (120 dB), where rounding looks like peaks.
std::vector<std::size_t> highestPeaks(const Spectrum& spectrum, std::size_t count);

/// Spectra of segments one after the other.
struct Spectrogram {
    std::string unit;
    std::vector<double> time_s; ///< middle of each segment; farther apart over a gap
    std::vector<double> frequency_Hz;
    std::vector<double> values; ///< a segment's lines beside each other

    double value(std::size_t segment, std::size_t line) const {
        return values[segment * frequency_Hz.size() + line];
    }
};

/// Of the same segments, without averaging. Without `segment_s` as for densities. Errors: as spectrum();
/// OutOfRange when it would have more than 50 million values.
Result<Spectrogram> spectrogram(const SignalView& signal, const SpectrumConfig& config,
                                const AbortCheck& checkAbort = {});

} // namespace halbench::control
