#include "app/workspaces/tune/design_table.h"

#include "app/figures/parameter_units.h"
#include "app/workspaces/tune/loop/design_names.h"
#include "control/base/units.h"
#include "widgets/controls/copy_menu.h"
#include "widgets/language/whole_numbers.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme_style.h"

#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace halbench::app {
namespace {

/// What designs are compared by comes first: in a narrow panel the rest is reached by scrolling.
enum Column {
    Name,
    Loop,
    PhaseMargin,
    GainMargin,
    Bandwidth,
    Overshoot,
    Ms,
    DelayMargin,
    Method,
    Kp,
    Ki,
    Kd
};
constexpr int Columns = Kd + 1;
constexpr int ProposedRow = 0;

QString amount(const std::optional<double>& value, int digits = 3) {
    return value && std::isfinite(*value) ? widgets::numberText(*value, digits) : QStringLiteral("\u2013");
}

/// So that a small window shows more of the columns: broken at the soft hyphen of a long word, else at a
/// space.
QString inTwoLines(QString title) {
    if (title.contains(QChar(QChar::SoftHyphen))) {
        return title.replace(QChar(QChar::SoftHyphen), QLatin1String("-\n"));
    }
    const int space = title.indexOf(QLatin1Char(' '));
    return space > 0 ? title.replace(space, 1, QLatin1Char('\n')) : title;
}

widgets::DisplayUnit gainUnit(const char* parameter, const DisplayUnits& units) {
    return widgets::displayUnit(parameterUnit(parameter), units.angle);
}

int alignmentOf(int column) {
    const bool isWords = column == Name || column == Loop || column == Method;
    return static_cast<int>((isWords ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
}

QString titled(const QString& name, const QString& unit) {
    return QStringLiteral("%1 [%2]").arg(name, unit);
}

} // namespace

DesignTable::DesignTable(QWidget* parent)
    : QWidget(parent), m_table(new QTableWidget(0, Columns, this)), m_keep(new QPushButton(this)),
      m_takeUp(new QPushButton(this)), m_remove(new QPushButton(this)), m_undo(new QPushButton(this)),
      m_redo(new QPushButton(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(widgets::PanelMargin_px);
    auto* buttons = new QGridLayout;
    buttons->setSpacing(widgets::PanelMargin_px);
    int at = 0;
    for (QPushButton* button : {m_keep, m_takeUp, m_remove, m_undo, m_redo}) {
        constexpr int InARow = 2; // three German ones do not fit beside the settings of a small window
        buttons->addWidget(button, at / InARow, at % InARow);
        ++at;
    }
    column->addLayout(buttons); // messages come over the bottom
    column->addWidget(m_table, 1);
    setTabOrder(m_redo, m_table);
    m_remove->setIcon(widgets::themedIcon(QStringLiteral("close")));
    m_undo->setIcon(widgets::themedIcon(QStringLiteral("revert")));
    m_table->setObjectName(QStringLiteral("designs"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_table->setTabKeyNavigation(false);
    widgets::addCopyMenu(*m_table);
    m_table->setItemDelegate(new widgets::WholeNumbers(m_table));
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Interactive);
    m_table->installEventFilter(this);
    connect(m_keep, &QPushButton::clicked, this, &DesignTable::keepRequested);
    connect(m_takeUp, &QPushButton::clicked, this, [this] { takeUpRequested(currentKept()); });
    connect(m_remove, &QPushButton::clicked, this, [this] { removeRequested(currentKept()); });
    connect(m_undo, &QPushButton::clicked, this, &DesignTable::undoRequested);
    connect(m_redo, &QPushButton::clicked, this, &DesignTable::redoRequested);
    connect(m_table, &QTableWidget::currentCellChanged, this, &DesignTable::refreshButtons);
    connect(m_table, &QTableWidget::cellChanged, this, [this](int row, int changed) {
        if (m_isFilling || changed != Name || row == ProposedRow) {
            return;
        }
        const QTableWidgetItem& cell = *m_table->item(row, Name);
        const bool isDrawn = cell.checkState() == Qt::Checked;
        const QString name = cell.text().trimmed();
        // Asked for once the table is done with its own change: the answer fills it anew.
        QMetaObject::invokeMethod(
            this,
            [this, row, isDrawn, name] {
                drawRequested(row - 1, isDrawn);
                renameRequested(row - 1, name);
            },
            Qt::QueuedConnection);
    });
    refreshWords();
    refreshButtons();
}

int DesignTable::currentKept() const {
    return m_table->currentRow() <= ProposedRow ? -1 : m_table->currentRow() - 1;
}

void DesignTable::setText(int row, int column, const QString& text) {
    QTableWidgetItem* cell = m_table->item(row, column);
    if (cell == nullptr) {
        cell = new QTableWidgetItem;
        cell->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        cell->setTextAlignment(alignmentOf(column));
        m_table->setItem(row, column, cell);
    }
    if (cell->text() != text) { // one that is being edited stays as it is typed
        cell->setText(text);
    }
}

void DesignTable::fillFigures(int row, const ComparedDesign& design) {
    const bool isKnown = design.gains.has_value();
    for (const int column : {Kp, Ki, Kd}) {
        if (!isKnown) { // another design may have stood here
            setText(row, column, {});
        }
    }
    if (isKnown) {
        setText(row, Kp, amount(design.gains->proportional * gainUnit("gain.kp", m_units).factor, 4));
        setText(row, Ki, amount(design.gains->integral * gainUnit("gain.ki", m_units).factor, 4));
        setText(row, Kd, amount(design.gains->derivative * gainUnit("gain.kd", m_units).factor, 4));
    }
    sayReason(row, design.predicted ? QString() : design.reason);
    if (!design.predicted) {
        return;
    }
    const AnalysisResult& loop = *design.predicted;
    setText(row, GainMargin, amount(loop.margins.gainMargin_ratio));
    setText(row, PhaseMargin, amount(loop.margins.phaseMargin_deg));
    setText(row, Ms, amount(1.0 / loop.margins.modulusMargin));
    setText(row, DelayMargin, amount(1e3 * loop.margins.delayMargin_s));
    setText(
        row, Bandwidth,
        amount(design.bandwidth_rad_s ? std::optional(*design.bandwidth_rad_s / (2.0 * Pi)) : std::nullopt));
    setText(row, Overshoot, amount(loop.step ? std::optional(loop.step->overshoot_percent) : std::nullopt));
    setText(row, Loop, loop.isStable ? tr("stable") : tr("UNSTABLE"));
}

/// Across the cells of the figures that are not there; empty: they are.
void DesignTable::sayReason(int row, const QString& reason) {
    const int columns = reason.isEmpty() ? 1 : DelayMargin - Loop + 1;
    if (m_table->columnSpan(row, Loop) != columns) {
        m_table->setSpan(row, Loop, 1, columns);
    }
    for (int column = Loop; column <= DelayMargin; ++column) {
        setText(row, column, column == Loop ? reason : QString());
    }
    QTableWidgetItem& cell = *m_table->item(row, Loop);
    cell.setToolTip(reason);
    // Its column is as wide as its other words: it reaches over the next ones.
    cell.setData(Qt::SizeHintRole, reason.isEmpty() ? QVariant() : QVariant(QSize(1, 1)));
}

void DesignTable::fillRow(int row, const ComparedDesign& design, bool isKept) {
    setText(row, Name, isKept ? QString::fromStdString(design.name) : tr("Proposed"));
    const QString method = designTitle(design.method);
    setText(row, Method, design.isFiltered ? tr("%1, with filters").arg(method) : method);
    if (isKept) {
        QTableWidgetItem& cell = *m_table->item(row, Name);
        const Qt::ItemFlags flags = cell.flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable;
        if (cell.flags() != flags) {
            cell.setFlags(flags);
        }
        const Qt::CheckState state = design.isDrawn ? Qt::Checked : Qt::Unchecked;
        if (cell.data(Qt::CheckStateRole) != state) {
            cell.setCheckState(state);
        }
    }
    fillFigures(row, design);
}

void DesignTable::setDesigns(const std::optional<ComparedDesign>& proposed,
                             const std::vector<ComparedDesign>& kept, const DisplayUnits& units) {
    m_units = units;
    m_hasProposed = proposed && proposed->predicted;
    m_isFilling = true;
    const int current = m_table->currentRow();
    m_table->setRowCount(static_cast<int>(kept.size()) + 1);
    fillRow(ProposedRow, proposed.value_or(ComparedDesign{}), false);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        fillRow(static_cast<int>(i) + 1, kept[i], true);
    }
    if (const int row = std::min(std::max(current, 0), m_table->rowCount() - 1); row != current) {
        m_table->setCurrentCell(row, Name);
    }
    m_isFilling = false;
    // Its hint forgets the box to tick, and a name that is being typed wants room.
    m_table->resizeColumnToContents(Name);
    m_table->setColumnWidth(Name, m_table->columnWidth(Name) + 5 * fontMetrics().averageCharWidth());
    refreshWords();
    refreshButtons();
}

void DesignTable::setHistory(bool canUndo, bool canRedo) {
    m_undo->setEnabled(canUndo);
    m_redo->setEnabled(canRedo);
}

void DesignTable::editName(int kept) {
    m_table->setCurrentCell(kept + 1, Name);
    m_table->setFocus(Qt::OtherFocusReason);
    m_table->editItem(m_table->item(kept + 1, Name));
}

void DesignTable::refreshButtons() {
    m_keep->setEnabled(m_hasProposed);
    m_takeUp->setEnabled(currentKept() >= 0);
    m_remove->setEnabled(currentKept() >= 0);
}

void DesignTable::refreshWords() {
    const auto gain = [this](const char* name, const char* parameter) {
        return titled(QString::fromLatin1(name), gainUnit(parameter, m_units).text);
    };
    QStringList labels{tr("Design"),
                       tr("Closed loop"),
                       titled(tr("Phase margin"), QStringLiteral("\u00b0")),
                       tr("Gain margin"),
                       titled(tr("Bandwidth"), QStringLiteral("Hz")),
                       titled(tr("Overshoot"), QStringLiteral("%")),
                       QStringLiteral("Ms"),
                       titled(tr("Delay margin"), QStringLiteral("ms")),
                       tr("Method"),
                       gain("K_P", "gain.kp"),
                       gain("K_I", "gain.ki"),
                       gain("K_D", "gain.kd")};
    for (QString& label : labels) {
        label = inTwoLines(label);
    }
    m_table->setHorizontalHeaderLabels(labels);
    for (int column = 0; column < Columns; ++column) {
        m_table->horizontalHeaderItem(column)->setTextAlignment(alignmentOf(column));
    }
    m_table->setAccessibleName(tr("Designs compared"));
    m_table->setToolTip(tr("A tick shows the design in the plots (Space), F2 renames it, Del removes it"));
    const std::tuple<QPushButton*, QString, QString> words[] = {
        {m_keep, tr("Save design"), tr("Save the proposed gains in the project under a name")},
        {m_takeUp, tr("Use this design"), tr("Use the gains of the selected design as proposed gains")},
        {m_remove, tr("Remove"), tr("Remove the selected design from the project")},
        {m_undo, tr("Undo"), tr("Undo the last change of the list (Ctrl+Z)")},
        {m_redo, tr("Redo"), tr("Redo the last undone change (Ctrl+Shift+Z)")}};
    for (const auto& [button, text, help] : words) {
        button->setText(text);
        button->setToolTip(help);
        button->setAccessibleName(text);
    }
}

bool DesignTable::eventFilter(QObject* watched, QEvent* event) {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (watched != m_table || (event->type() != QEvent::KeyPress && !isOverride)) {
        return QWidget::eventFilter(watched, event);
    }
    auto& key = static_cast<QKeyEvent&>(*event);
    if (isOverride) { // the panel around has a history of its own: of the gains
        const bool isOurs = key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
        event->setAccepted(isOurs);
        return isOurs;
    }
    if (key.key() == Qt::Key_Escape) {
        event->ignore(); // Esc stops the motor
        return true;
    }
    const std::pair<bool, QPushButton*> ways[] = {{key.key() == Qt::Key_Delete, m_remove},
                                                  {key.matches(QKeySequence::Undo), m_undo},
                                                  {key.matches(QKeySequence::Redo), m_redo}};
    for (const auto& [isIt, button] : ways) {
        if (isIt) {
            button->click();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void DesignTable::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
