#pragma once

#include "app/workbench/signals/signal_stretch.h"
#include "app/workspaces/analysis/spectrum_figure.h"
#include "widgets/spectrogram/spectrogram_picture.h"

namespace halbench::app {

/// Spectra of the stretch's segments. Without a length of segments there are about as many segments as lines,
/// of N rows 2 sqrt(N) each. Errors: those of control::spectrogram().
Result<control::Spectrogram> spectrogramOf(const SignalStretch& stretch, control::SpectrumConfig config);

/// How many dB ten times as much is.
double decade_dB(control::SpectrumScale scale);

/// The picture, in the unit shown.
widgets::SpectrogramPicture spectrogramPicture(const control::Spectrogram& spectrogram,
                                               control::SpectrumScale scale, const SpectrumLook& look);

/// Caption of a spectrogram: distance of lines and resolution, segments and how far they are apart.
QString spectrogramWords(const control::Spectrogram& spectrogram, control::WindowShape window);

} // namespace halbench::app
