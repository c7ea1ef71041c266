#include "app/workspaces/recordings/run_overlay.h"

#include "app/workbench/document_files.h"
#include "app/workspaces/parts/compact_table.h"
#include "app/workspaces/parts/field_grid.h"
#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/copy_menu.h"
#include "widgets/controls/floating_rows.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/language/whole_numbers.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

constexpr double LongestCursor_s = 1e6;
constexpr int MostRuns = 16; ///< eight colours, plain and dashed
constexpr int ShownLetters = 8;
constexpr double Spans_s[] = {100.0, 10.0, 1.0, 0.1, 0.01};

std::vector<std::string> pathsOf(const QStringList& list) {
    std::vector<std::string> paths;
    for (const QString& path : list) {
        paths.push_back(path.toStdString());
    }
    return paths;
}

/// One of them at least; the others are left out then.
bool haveTrigger(const std::vector<ComparedRun>& runs) {
    return std::any_of(runs.begin(), runs.end(), [](const ComparedRun& run) {
        return alignedZero_s(run, {RunAlignment::Moment::Trigger, {}}).has_value();
    });
}

} // namespace

RunOverlay::RunOverlay(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::PanelMargin_px);
    buildChoices();
    m_message = new widgets::MessageBar(this);
    m_message->setObjectName(QStringLiteral("overlay_message"));
    m_hint = makeNote(this);
    m_view = new widgets::FigureView(this);
    m_view->setAccessibleName(tr("Overlay of the selected recordings"));
    buildValues();
    column->addWidget(m_hint);
    auto* row = new QHBoxLayout;
    row->addWidget(m_view, 5);
    row->addWidget(m_values, 3);
    column->addLayout(row, 1);
    (new widgets::FloatingRows(*m_view, Qt::TopEdge, this))->addRow(*m_message);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &RunOverlay::draw);
    connect(m_view, &widgets::FigureView::exportRequested, this, [this] {
        savePicture(this, m_chooser, QStringLiteral("overlay.svg"), m_files, *m_view,
                    [this](const Error& error) {
                        m_message->showMessage({widgets::Severity::Error,
                                                widgets::inWords(error.message),
                                                widgets::inWords(error.hint),
                                                {}});
                    });
    });
    showFigure({});
}

RunOverlay::~RunOverlay() {
    if (m_isStale) {
        *m_isStale = true;
    }
}

void RunOverlay::buildValues() {
    m_values = new QTableWidget(0, 2, this);
    m_values->setAccessibleName(tr("Values at the cursor"));
    m_values->setToolTip(tr("Values of each recording at the cursor"));
    m_values->setHorizontalHeaderLabels({tr("Recording"), tr("At the cursor")});
    m_values->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_values->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_values->setItemDelegate(new widgets::WholeNumbers(m_values));
    setCompact(*m_values);
    m_values->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_values->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_values->setTabKeyNavigation(false);
    widgets::addCopyMenu(*m_values);
}

void RunOverlay::buildChoices() {
    m_signal = new QComboBox(this);
    m_signal->setToolTip(tr("Signals common to all selected recordings"));
    m_align = new QComboBox(this);
    m_align->setToolTip(tr("Time zero: first sample, trigger, or a common marker"));
    m_cursor = makeNumberField({tr("Time of the cursor"),
                                tr("Position of the cursor line and of the values beside it"),
                                QStringLiteral("s"), 3, -LongestCursor_s, LongestCursor_s, 0.1},
                               this);
    auto* grid = new FieldGrid(4, this);
    grid->addTitled(tr("Signal"), m_signal->toolTip(), m_signal);
    grid->addTitled(tr("Aligned at"), m_align->toolTip(), m_align);
    grid->addTitled(tr("Cursor"), m_cursor->toolTip(), m_cursor);
    m_signal->setAccessibleName(tr("Signal that is compared"));
    m_align->setAccessibleName(tr("Alignment of the recordings"));
    m_cursor->setAccessibleName(tr("Time of the cursor"));
    m_span = grid->addBox(tr("Range"), tr("Whole recording or a range around the cursor"), {tr("all")});
    for (const double span_s : Spans_s) {
        m_span->addItem(tr("%1 s around the cursor").arg(widgets::numberText(span_s, 3)), span_s);
    }
    layout()->addWidget(grid);
    for (QComboBox* box : {m_signal, m_align, m_span}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // markers are long
        box->setMinimumContentsLength(ShownLetters);
        connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &RunOverlay::draw);
    }
    connect(m_cursor, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &RunOverlay::moveCursor);
}

void RunOverlay::setFiles(const QStringList& paths) {
    if (paths == m_paths) {
        return;
    }
    m_paths = paths;
    if (m_isStale) {
        *m_isStale = true;
    }
    m_isStale = std::make_shared<std::atomic<bool>>(false);
    const std::vector<std::string> wanted = pathsOf(paths.mid(0, MostRuns));
    const auto checkAbort = [isStale = m_isStale]() -> Result<void> {
        return *isStale ? failure(ErrorCode::Interrupted, {}, {}) : Result<void>();
    };
    m_reading.run([wanted, checkAbort] { return readRuns(wanted, checkAbort); },
                  [this, left = paths.size() - static_cast<int>(wanted.size())](ReadRuns read) {
                      take(std::move(read), left);
                  });
}

void RunOverlay::take(ReadRuns read, int left) {
    m_runs = std::make_shared<const std::vector<ComparedRun>>(std::move(read.runs));
    QStringList refused;
    QString remedy;
    for (const Error& error : read.refused) {
        refused.append(widgets::inWords(error.message));
        remedy = widgets::inWords(error.hint);
    }
    if (left > 0) {
        refused.append(tr("Maximum %1 recordings in an overlay").arg(MostRuns));
    }
    const bool isAnyChanged = addWarnings(refused);
    if (isAnyChanged && remedy.isEmpty()) {
        remedy = tr("Compare it with a copy: samples may be missing or changed.");
    }
    if (refused.isEmpty()) {
        m_message->clear();
    } else {
        m_message->showMessage({!read.refused.empty() ? widgets::Severity::Error
                                : isAnyChanged        ? widgets::Severity::Warning
                                                      : widgets::Severity::Information,
                                refused.join(QLatin1Char('\n')),
                                remedy,
                                {}});
    }
    refreshChoices();
    draw();
}

/// Of runs that are not as they were recorded; whether there are any.
bool RunOverlay::addWarnings(QStringList& lines) const {
    const int before = lines.size();
    for (const ComparedRun& run : *m_runs) {
        for (const std::string& warning : run.warnings) {
            lines.append(widgets::inWords(warning));
        }
    }
    return lines.size() > before;
}

/// What was chosen stays when it is still there.
void RunOverlay::refreshChoices() {
    const QString signal = m_signal->currentData().toString();
    const QString moment = m_align->currentData().toString();
    const QSignalBlocker quietSignal(m_signal);
    const QSignalBlocker quietAlign(m_align);
    m_signal->clear();
    for (const std::string& name : commonSignals(*m_runs)) {
        m_signal->addItem(signalWords(name), QString::fromStdString(name));
    }
    m_signal->setCurrentIndex(std::max(0, m_signal->findData(signal)));
    m_align->clear();
    m_align->addItem(tr("start"), QStringLiteral("start"));
    if (haveTrigger(*m_runs)) {
        m_align->addItem(tr("trigger"), QStringLiteral("trigger"));
    }
    for (const std::string& text : commonMarkers(*m_runs)) {
        const QString words = QString::fromStdString(text);
        m_align->addItem(tr("marker: %1").arg(words), QStringLiteral("marker ") + words);
    }
    m_align->setCurrentIndex(std::max(0, m_align->findData(moment)));
}

RunAlignment RunOverlay::alignment() const {
    const QString moment = m_align->currentData().toString();
    if (moment == QLatin1String("trigger")) {
        return {RunAlignment::Moment::Trigger, {}};
    }
    if (moment.startsWith(QLatin1String("marker "))) {
        return {RunAlignment::Moment::Marker, moment.mid(7).toStdString()};
    }
    return {};
}

std::string RunOverlay::signal() const {
    return m_signal->currentData().toString().toStdString();
}

DisplayQuantity RunOverlay::shown() const {
    for (const ComparedRun& run : *m_runs) {
        const int column = run.recording.layout->indexOf(signal());
        if (column >= 0) {
            return displayQuantity(run.recording.layout->columns[static_cast<std::size_t>(column)].unit,
                                   m_bench.displayUnits());
        }
    }
    return {};
}

OverlayView RunOverlay::view() const {
    const DisplayQuantity quantity = shown();
    OverlayView view;
    view.signal = signal();
    view.alignment = alignment();
    view.y.quantity = m_signal->currentText().toStdString();
    view.y.unit = quantity.unit.toStdString();
    view.factor = quantity.factor;
    if (const double span_s = m_span->currentData().toDouble(); span_s > 0.0) {
        view.span_s = {m_cursor->value() - span_s / 2.0, m_cursor->value() + span_s / 2.0};
    }
    return view;
}

void RunOverlay::draw() {
    m_drawing.run([runs = m_runs, view = view()] { return overlayFigure(*runs, view); },
                  [this](widgets::Figure figure) { showFigure(std::move(figure)); });
}

void RunOverlay::showFigure(widgets::Figure figure) {
    const bool isEmpty = figure.panels.empty();
    m_hint->setVisible(isEmpty);
    m_hint->setText(m_runs->empty()
                        ? tr("Select recordings in the list to overlay their curves.")
                        : tr("No common data in this range. Choose another signal, alignment or range."));
    m_view->setVisible(!isEmpty);
    m_values->setVisible(!isEmpty);
    if (!isEmpty) {
        figure.title = tr("Overlay of the selected recordings").toStdString();
        figure.x = {tr("time").toStdString(), "s", false, figure.x.min, figure.x.max, {}};
        figure.panels.front().lines = {{widgets::ReferenceLine::Direction::Vertical, m_cursor->value(), {}}};
        m_view->setFigure(std::move(figure));
    }
    refreshCursor();
}

/// Only a part about the cursor has to be drawn anew; else the curves stay.
void RunOverlay::moveCursor() {
    if (m_view->isEmpty() || !m_view->isVisibleTo(this) || m_span->currentIndex() > 0) {
        draw();
    } else {
        showFigure(m_view->figure());
    }
}

void RunOverlay::refreshCursor() {
    const DisplayQuantity quantity = shown();
    m_values->setRowCount(static_cast<int>(m_runs->size()));
    int row = 0;
    for (const ComparedRun& run : *m_runs) {
        const std::optional<double> zero_s = alignedZero_s(run, alignment());
        const std::optional<double> value =
            zero_s ? valueAt(run, signal(), *zero_s, m_cursor->value()) : std::nullopt;
        const QString text =
            value ? widgets::numberText(*value * quantity.factor, 6) + QLatin1Char(' ') + quantity.unit
                  : QStringLiteral("\u2013");
        m_values->setItem(row, 0, new QTableWidgetItem(QString::fromStdString(run.name)));
        auto* item = new QTableWidgetItem(text);
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_values->setItem(row++, 1, item);
    }
}

} // namespace halbench::app
