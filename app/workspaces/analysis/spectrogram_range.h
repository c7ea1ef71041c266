#pragma once

#include "app/workspaces/analysis/spectrum_figure.h"

#include <QWidget>

namespace halbench::widgets {
class OptionalNumberEdit;
}

namespace halbench::app {

/// Which frequencies a spectrogram shows and over which values its colours reach; what is empty follows the
/// data.
class SpectrogramRange : public QWidget {
    Q_OBJECT

public:
    explicit SpectrogramRange(QWidget* parent);

    /// Takes the limits into the look.
    void put(SpectrumLook& look) const;
    /// What the ends of the colours are said in: "mT", "dB re 1 mT". In another unit they mean nothing; from
    /// values to dB and back they go along.
    void setValueUnit(const QString& unit, double decade_dB);
    /// Why limits are not used; empty: they are.
    QString problem() const;

Q_SIGNALS:
    void edited();

private:
    void limitColours(bool isDecibel);

    widgets::OptionalNumberEdit* m_lowest = nullptr;
    widgets::OptionalNumberEdit* m_highest = nullptr;
    widgets::OptionalNumberEdit* m_darkest = nullptr;
    widgets::OptionalNumberEdit* m_brightest = nullptr;
    QString m_unit;
    double m_decade_dB = 0.0; ///< 0: values
};

} // namespace halbench::app
