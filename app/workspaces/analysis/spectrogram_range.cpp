#include "app/workspaces/analysis/spectrogram_range.h"

#include "app/workspaces/parts/field_grid.h"
#include "widgets/controls/optional_number_edit.h"

#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

constexpr int Columns = 4;
constexpr double MostHertz = 1e9;
constexpr double MostValue = 1e12;
constexpr double MostDecibels = 400.0;

} // namespace

SpectrogramRange::SpectrogramRange(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* grid = new FieldGrid(Columns, this);
    const auto add = [&](const QString& title, const QString& toolTip) {
        auto* edit = new widgets::OptionalNumberEdit(grid);
        grid->addTitled(title, toolTip, edit);
        edit->setExplanation(toolTip);
        edit->setPlaceholderText(tr("automatic"));
        edit->setLimits({0.0, MostHertz, false});
        connect(edit, &widgets::OptionalNumberEdit::valueChanged, this, &SpectrogramRange::edited);
        return edit;
    };
    m_lowest = add(tr("Min. [Hz]"), tr("Lowest frequency shown; empty: all"));
    m_highest = add(tr("Max. [Hz]"), tr("Highest frequency shown; empty: all"));
    m_darkest = add(tr("Colour scale min"), tr("Value of the darkest colour; empty: automatic"));
    m_brightest = add(tr("Colour scale max"), tr("Value of the brightest colour; empty: automatic"));
    limitColours(false);
    column->addWidget(grid);
}

void SpectrogramRange::limitColours(bool isDecibel) {
    for (widgets::OptionalNumberEdit* edit : {m_darkest, m_brightest}) {
        edit->setLimits(isDecibel ? widgets::NumberLimits{-MostDecibels, MostDecibels}
                                  : widgets::NumberLimits{0.0, MostValue});
    }
}

void SpectrogramRange::put(SpectrumLook& look) const {
    look.lowest_Hz = m_lowest->value();
    look.highest_Hz = m_highest->value();
    look.darkest = m_darkest->value();
    look.brightest = m_brightest->value();
}

void SpectrogramRange::setValueUnit(const QString& unit, double decade_dB) {
    const double before_dB = std::exchange(m_decade_dB, decade_dB);
    const bool isSame = std::exchange(m_unit, unit) == unit;
    if (isSame && before_dB == decade_dB) {
        return;
    }
    limitColours(decade_dB > 0.0);
    for (widgets::OptionalNumberEdit* edit : {m_darkest, m_brightest}) {
        std::optional<double> value = isSame ? edit->value() : std::nullopt;
        if (value && before_dB > 0.0) {
            value = std::pow(10.0, *value / before_dB);
        }
        if (value && decade_dB > 0.0) {
            value = *value > 0.0 ? std::optional(decade_dB * std::log10(*value)) : std::nullopt;
        }
        edit->setValue(value);
    }
}

QString SpectrogramRange::problem() const {
    const auto isEmpty = [](const widgets::OptionalNumberEdit& low, const widgets::OptionalNumberEdit& high) {
        return low.value() && high.value() && *low.value() >= *high.value();
    };
    if (isEmpty(*m_lowest, *m_highest)) {
        return tr("The lowest frequency must be below the highest. All are shown.");
    }
    return isEmpty(*m_darkest, *m_brightest)
               ? tr("The minimum of the colour scale must be below its maximum. Automatic scale used.")
               : QString();
}

} // namespace halbench::app
