#include "app/workspaces/analysis/spectrum_panel.h"

#include "app/documents/spectrum_table.h"
#include "app/workbench/signals/signal_stretch.h"
#include "app/workspaces/analysis/spectrogram_figure.h"
#include "app/workspaces/analysis/spectrogram_range.h"
#include "app/workspaces/parts/field_grid.h"
#include "app/workspaces/parts/panel_parts.h"
#include "app/workspaces/parts/signal_box.h"
#include "widgets/controls/copy_menu.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/display_units.h"
#include "widgets/language/whole_numbers.h"
#include "widgets/spectrogram/spectrogram_view.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTableWidget>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr std::size_t MostRows = std::size_t{1} << 18; ///< copied at once, about a millisecond
constexpr std::size_t ListedPeaks = 8;
constexpr int PeakDigits = 5;
constexpr int GridColumns = 3;
constexpr double PerCent = 100.0;

/// In the order of control::WindowShape; names of people are not translated.
QStringList windowNames() {
    return {SpectrumPanel::tr("Rectangular"),  QStringLiteral("Hann"),
            QStringLiteral("Hamming"),         QStringLiteral("Blackman"),
            QStringLiteral("Blackman-Harris"), SpectrumPanel::tr("Flat top")};
}

} // namespace

SpectrumPanel::SpectrumPanel(Workbench& bench, QWidget* parent) : LivePicture(bench, parent) {
    begin(tr("No data to analyse"),
          tr("Live spectrum of a signal. Connect a device: choose one on the left, or try the simulated "
             "motor."),
          buildContent());
}

QWidget* SpectrumPanel::buildContent() {
    auto* content = new QWidget(this);
    QVBoxLayout* column = makePanelColumn(content);
    auto* grid = new FieldGrid(GridColumns, content);
    buildBoxes(*grid);
    buildNumbers(*grid);
    column->addWidget(grid);
    m_range = new SpectrogramRange(content);
    m_range->hide();
    connect(m_range, &SpectrogramRange::edited, this, &SpectrumPanel::showAgain);
    column->addWidget(m_range);
    auto* bar = new QToolBar(tr("Spectrum"), content);
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_logFrequency =
        addSwitch(*bar, tr("Log frequency"), tr("Logarithmic axis of the frequency"), "X", false);
    m_logValue = addSwitch(*bar, tr("Log values"), tr("Logarithmic axis of the values"), "Y", true);
    m_overTime = addSwitch(*bar, tr("Spectrogram"),
                           tr("Spectrogram: spectra of the segments over time, in colours"), "O", false);
    m_decibel = addSwitch(*bar, tr("dB"), tr("Colour scale in dB relative to 1 of the unit"), "D", false);
    m_decibel->setEnabled(false);
    m_hold = addSwitch(*bar, tr("Hold"), tr("Freeze the spectrum; data acquisition continues"), "H", false);
    column->addWidget(bar);
    column->addWidget(buildPictures(content), 1);
    addData({m_view, m_gram}, tr("Save the lines as a table (CSV), in SI units"),
            QStringLiteral("spectrum.csv"));
    m_words = makeWords(content, tr("Summary of the spectrum"));
    column->addWidget(m_words);
    return content;
}

QWidget* SpectrumPanel::buildPictures(QWidget* parent) {
    m_pictures = new QStackedWidget(parent);
    auto* lines = new QWidget(m_pictures);
    auto* row = new QHBoxLayout(lines);
    row->setContentsMargins(0, 0, 0, 0);
    m_view =
        makeView(lines, tr("Arrow keys move along the lines; Ctrl+C copies the picture, Ctrl+E saves it"),
                 QStringLiteral("spectrum.svg"));
    row->addWidget(m_view, 1);
    buildPeaks(lines);
    row->addWidget(m_peaks);
    m_gram = new widgets::SpectrogramView(m_pictures);
    m_gram->setToolTip(tr("Arrow keys move from the highest value (Shift: ten steps); Ctrl+C copies the "
                          "picture, Ctrl+E saves it"));
    connect(m_gram, &widgets::SpectrogramView::exportRequested, this,
            [this] { savePictureAs(QStringLiteral("spectrogram.png"), m_gram->taken()); });
    m_pictures->addWidget(lines);
    m_pictures->addWidget(m_gram);
    connect(m_overTime, &QAction::toggled, this, &SpectrumPanel::showOverTime);
    return m_pictures;
}

void SpectrumPanel::buildBoxes(FieldGrid& grid) {
    m_signal = makeBox(&grid);
    grid.addTitled(tr("Signal"), tr("Signal to analyse; a signal can also be dropped here"), m_signal);
    m_scale = grid.addBox(
        tr("Quantity"),
        tr("Amplitude or rms for steady sines; densities for noise, independent of the segment length"),
        {tr("Amplitude"), tr("RMS"), tr("Power density"), tr("Amplitude density")});
    m_window = grid.addBox(tr("Window"),
                           tr("Window function: Hann in general, flat top for exact amplitudes, "
                              "Blackman-Harris for weak lines near strong ones"),
                           windowNames());
    m_window->setCurrentIndex(static_cast<int>(control::WindowShape::Hann));
    for (QComboBox* box : {m_scale, m_window}) {
        connect(box, QOverload<int>::of(&QComboBox::activated), this, &SpectrumPanel::askAnew);
    }
}

void SpectrumPanel::buildNumbers(FieldGrid& grid) {
    m_stretch = grid.addNumber({tr("Time span"), tr("Length of the analysed data, up to now"),
                                QStringLiteral("s"), 1, 0.1, 3600.0, 1.0});
    m_stretch->setQuantity(10.0);
    m_segment = grid.addNumber({tr("Segment"),
                                tr("Longer segments give finer resolution, more segments less noise. 0: full "
                                   "length for amplitudes, at least eight segments for densities"),
                                QStringLiteral("s"), 3, 0.0, 3600.0, 0.1});
    m_segment->setSpecialValueText(tr("automatic"));
    m_overlap = grid.addNumber(
        {tr("Overlap"), tr("Overlap of neighbouring segments"), QStringLiteral("%"), 0, 0.0, 95.0, 5.0});
    m_overlap->setQuantity(50.0);
    for (widgets::QuantityEdit* number : {m_stretch, m_segment, m_overlap}) {
        connect(number, &widgets::QuantityEdit::edited, this, &SpectrumPanel::askAnew);
    }
}

void SpectrumPanel::buildPeaks(QWidget* parent) {
    m_peaks = new QTableWidget(0, 2, parent);
    m_peaks->setAccessibleName(tr("Highest peaks"));
    m_peaks->setToolTip(tr("Local maxima outside the window's main lobe"));
    m_peaks->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_peaks->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_peaks->setTabKeyNavigation(false);
    m_peaks->setItemDelegate(new widgets::WholeNumbers(m_peaks));
    widgets::addCopyMenu(*m_peaks);
    m_peaks->verticalHeader()->hide();
    m_peaks->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_peaks->setFont(widgets::tabularFont(m_peaks->font()));
    m_peaks->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Expanding);
    // Room for the longest numbers and the scroll bar from the start: numbers change with every spectrum.
    const QString longest = widgets::numberText(8.8888888e-18, PeakDigits);
    m_peaks->setFixedWidth(2 * m_peaks->fontMetrics().horizontalAdvance(longest + QStringLiteral("00")) +
                           aroundPeaks_px());
}

QAction* SpectrumPanel::addSwitch(QToolBar& bar, const QString& text, const QString& what, const char* key,
                                  bool isOn) {
    auto* action = new QAction(text, this);
    action->setCheckable(true);
    action->setChecked(isOn);
    action->setShortcut(QKeySequence(QLatin1String(key)));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    action->setToolTip(QStringLiteral("%1 (%2)").arg(what, QLatin1String(key)));
    addAction(action);
    bar.addAction(action);
    bar.widgetForAction(action)->setAccessibleName(text);
    connect(action, &QAction::toggled, this, &SpectrumPanel::showAgain);
    return action;
}

/// The same numbers in another look.
void SpectrumPanel::showAgain() {
    m_decibel->setEnabled(m_overTime->isChecked() && m_logValue->isChecked());
    if (m_spectrum) {
        showSpectrum(*m_spectrum, look());
    } else if (m_spectrogram) {
        dressRange();
        showSpectrogram(*m_spectrogram, look());
    }
}

/// With the same settings; the focus goes along with the picture.
void SpectrumPanel::showOverTime(bool isOverTime) {
    const bool hadFocus = m_view->hasFocus() || m_gram->hasFocus();
    m_spectrum.reset();
    m_spectrogram.reset();
    m_pictures->setCurrentIndex(isOverTime ? 1 : 0);
    m_range->setVisible(isOverTime);
    m_decibel->setEnabled(isOverTime && m_logValue->isChecked());
    if (hadFocus && isOverTime) {
        m_gram->setFocus();
    } else if (hadFocus) {
        m_view->setFocus();
    }
    askAnew();
}

void SpectrumPanel::takeCatalogue(const devices::Catalogue& catalogue) {
    m_signal->setCatalogue(catalogue, {"speed", "position"});
}

bool SpectrumPanel::isHeld() const {
    return m_hold->isChecked();
}

/// As `halbench spectrum` writes it.
LivePicture::Table SpectrumPanel::table() const {
    if (m_spectrum) {
        return [spectrum = *m_spectrum, unit = m_unit] { return spectrumTable(spectrum, unit); };
    }
    if (m_spectrogram) {
        return [spectrogram = *m_spectrogram, unit = m_unit, scale = m_shownAs] {
            return spectrogramTable(spectrogram, unit, scale);
        };
    }
    return {};
}

void SpectrumPanel::compute() {
    if (m_overTime->isChecked()) {
        computeOverTime();
        return;
    }
    const SignalStretch last =
        lastStretch(bench().history(), m_signal->signal(), m_stretch->value(), MostRows);
    task().run(
        [stretch = last, config = config()] {
            const SignalStretch open = withOpenGaps(stretch);
            return control::spectrum({open.time_s, open.values, open.unit}, config);
        },
        [this, look = look(), unit = last.unit](const Result<control::Spectrum>& spectrum) {
            m_unit = unit;
            m_spectrum = spectrum ? std::optional(*spectrum) : std::nullopt;
            showSpectrum(spectrum, look);
        });
}

void SpectrumPanel::computeOverTime() {
    dressRange();
    const SignalStretch last =
        lastStretch(bench().history(), m_signal->signal(), m_stretch->value(), MostRows);
    task().run(
        [stretch = last, config = config()] { return spectrogramOf(stretch, config); },
        [this, unit = last.unit, scale = config().scale](const Result<control::Spectrogram>& spectrogram) {
            m_unit = unit;
            m_shownAs = scale;
            m_spectrogram = spectrogram ? std::optional(*spectrogram) : std::nullopt;
            showSpectrogram(spectrogram, look()); // as it is wanted by now
        });
}

control::SpectrumConfig SpectrumPanel::config() const {
    control::SpectrumConfig config;
    config.scale = static_cast<control::SpectrumScale>(m_scale->currentIndex());
    config.window = static_cast<control::WindowShape>(m_window->currentIndex());
    config.overlap_ratio = m_overlap->value() / PerCent;
    if (m_segment->value() > 0.0) {
        config.segment_s = m_segment->value();
    }
    return config;
}

SpectrumLook SpectrumPanel::look() const {
    SpectrumLook look;
    look.signal = signalWords(m_signal->signal());
    look.quantity = shown(*m_signal);
    look.isFrequencyLogarithmic = m_logFrequency->isChecked();
    look.isValueLogarithmic = m_logValue->isChecked();
    look.isDecibel = m_decibel->isChecked();
    m_range->put(look);
    return look;
}

/// The ends of the colours are in the unit of their scale.
void SpectrumPanel::dressRange() {
    const auto scale = static_cast<control::SpectrumScale>(m_scale->currentIndex());
    const bool isDecibel = m_decibel->isChecked() && m_logValue->isChecked();
    m_range->setValueUnit(m_signal->currentText() + spectrumUnitText(shown(*m_signal).unit, scale),
                          isDecibel ? decade_dB(scale) : 0.0);
}

/// A refusal leaves the picture empty and says what to do.
void SpectrumPanel::showSpectrum(const Result<control::Spectrum>& spectrum, const SpectrumLook& look) {
    if (!spectrum) {
        m_view->clear();
        showPeaks({}, {});
        sayWarning(spectrum.error());
        return;
    }
    showRole(*m_words, widgets::Role::Muted);
    m_view->setFigure(spectrumFigure(*spectrum, look));
    m_words->setText(spectrumWords(*spectrum, look));
    showPeaks(spectrumPeaks(*spectrum, look, ListedPeaks),
              spectrumUnitText(look.quantity.unit, spectrum->config.scale));
}

void SpectrumPanel::showSpectrogram(const Result<control::Spectrogram>& spectrogram,
                                    const SpectrumLook& look) {
    if (!spectrogram) {
        m_gram->clear();
        sayWarning(spectrogram.error());
        return;
    }
    const QString problem = m_range->problem();
    showRole(*m_words, problem.isEmpty() ? widgets::Role::Muted : widgets::Role::Warn);
    const control::SpectrumConfig shown = config();
    m_gram->setPicture(spectrogramPicture(*spectrogram, shown.scale, look));
    m_words->setText(problem.isEmpty() ? spectrogramWords(*spectrogram, shown.window) : problem);
}

int SpectrumPanel::aroundPeaks_px() const {
    return 2 * m_peaks->frameWidth() + m_peaks->verticalScrollBar()->sizeHint().width();
}

void SpectrumPanel::showPeaks(const std::vector<SpectrumPeak>& peaks, const QString& unit) {
    m_peaks->setHorizontalHeaderLabels(
        {tr("Peak [Hz]"), unit.isEmpty() ? tr("Value") : tr("Value [%1]").arg(unit)});
    m_peaks->setRowCount(static_cast<int>(peaks.size()));
    for (int row = 0; row < m_peaks->rowCount(); ++row) {
        const SpectrumPeak& peak = peaks[static_cast<std::size_t>(row)];
        int column = 0;
        for (const double value : {peak.frequency_Hz, peak.value}) {
            auto* item = new QTableWidgetItem(widgets::numberText(value, PeakDigits));
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_peaks->setItem(row, column++, item);
        }
    }
    // A number that is cut is another number; the width only grows, so that nothing jumps.
    m_peaks->horizontalHeader()->resizeSections(QHeaderView::ResizeToContents);
    const int needed_px = m_peaks->horizontalHeader()->length() + aroundPeaks_px();
    m_peaks->setFixedWidth(std::max(m_peaks->minimumWidth(), needed_px));
}

} // namespace halbench::app
