#include "app/workspaces/recordings/import_table.h"

#include "devices/formats/foreign_unit.h"
#include "devices/formats/known_signals.h"

#include <QCompleter>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int NameRow = 0;
constexpr int UnitRow = 1;
constexpr int SaidRows = 2;
constexpr int LabelRole = Qt::UserRole; ///< of which column this is the name or the unit

QStringList knownNames() {
    QStringList names;
    for (const devices::KnownSignal& signal : devices::knownSignals()) {
        names << QString::fromUtf8(signal.name.data(), static_cast<int>(signal.name.size()));
    }
    return names;
}

QStringList knownUnits() {
    QStringList words;
    for (const std::string_view word : devices::foreignUnitWords()) {
        words << QString::fromUtf8(word.data(), static_cast<int>(word.size()));
    }
    return words;
}

/// Offers what has a meaning; anything else can be written too, and the plan judges it.
class SayingDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                          const QModelIndex& index) const override {
        auto* edit = new QLineEdit(parent);
        edit->setFrame(false);
        edit->setAccessibleName(index.data(LabelRole).toString());
        edit->setToolTip(index.data(Qt::ToolTipRole).toString());
        edit->setCompleter(new QCompleter(index.row() == NameRow ? knownNames() : knownUnits(), edit));
        return edit;
    }
};

QString theirs(const std::vector<devices::CsvColumn>& columns, std::size_t index) {
    return QString::fromStdString(devices::columnWord(columns, index));
}

QString chosen(const QString& said, const QString& found) {
    return said.isEmpty() ? found : said;
}

/// What the user said is seen, and how it is taken back.
void dress(QTableWidgetItem& cell, const QString& label, bool isSaid, const QString& toolTip) {
    QFont font = cell.font();
    font.setBold(isSaid);
    cell.setFont(font);
    cell.setToolTip(isSaid
                        ? ImportTable::tr("Set by you. Clear it (Delete) to use the value found in the table")
                        : toolTip);
    cell.setData(LabelRole, label);
    cell.setData(Qt::AccessibleTextRole, QStringLiteral("%1: %2").arg(label, cell.text()));
}

/// Flags that stay are not set again: that would write over what is being edited.
void setEditable(QTableWidgetItem& cell, bool isEditable) {
    Qt::ItemFlags flags = cell.flags();
    flags.setFlag(Qt::ItemIsEditable, isEditable);
    if (flags != cell.flags()) {
        cell.setFlags(flags);
    }
}

} // namespace

ImportTable::ImportTable(QWidget* parent) : QTableWidget(parent) {
    setAccessibleName(tr("Preview of the first rows"));
    setToolTip(tr("First rows in the units of the recording, with the signal name of each column above"));
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    setTabKeyNavigation(false);
    setItemDelegate(new SayingDelegate(this));
    connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) { onItem(*item); });
}

void ImportTable::forget() {
    m_columns.clear();
    m_said.clear();
    m_time.reset();
    showUnread();
}

void ImportTable::showLook(const TableLook& look) {
    const bool isRead = look.first.rows() > 0;
    m_columns = look.plan.columns;
    m_said.resize(m_columns.size());
    m_time = look.plan.time;
    m_shift = isRead && !m_time ? 1 : 0;
    show(isRead ? previewOf(look) : linesOf(look.plan), isRead);
}

void ImportTable::showUnread() {
    ImportPreview preview;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        preview.headers << tr("column %1").arg(theirs(m_columns, i));
    }
    m_shift = 0;
    show(preview, false);
}

int ImportTable::firstRow() const {
    return m_columns.empty() ? 0 : SaidRows;
}

/// In place: what is being written in another cell stays.
void ImportTable::show(const ImportPreview& preview, bool isRead) {
    const QSignalBlocker quiet(this);
    if (columnCount() != preview.headers.size() || verticalHeader()->isHidden() != m_columns.empty()) {
        clear(); // its cells become others
    }
    setColumnCount(preview.headers.size());
    setRowCount(static_cast<int>(preview.rows.size()) + firstRow());
    setHorizontalHeaderLabels(preview.headers);
    showRowTitles();
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        showColumn(i);
    }
    for (int row = firstRow(); row < rowCount(); ++row) {
        const QStringList& cells = preview.rows[static_cast<std::size_t>(row - firstRow())];
        for (int column = 0; column < columnCount(); ++column) {
            showCell(row, column, cells.value(column), isRead ? Qt::AlignRight : Qt::AlignLeft);
        }
    }
    for (int row = 0; row < firstRow(); ++row) {
        for (int column = 0; column < m_shift; ++column) {
            showCell(row, column, {}, Qt::AlignLeft);
        }
    }
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

void ImportTable::showRowTitles() {
    QStringList titles;
    if (firstRow() > 0) {
        titles << tr("Name") << tr("Unit");
    }
    for (int row = firstRow(); row < rowCount(); ++row) {
        titles << QString::number(row - firstRow() + 1);
    }
    setVerticalHeaderLabels(titles);
    verticalHeader()->setVisible(firstRow() > 0);
    setCornerButtonEnabled(false); // all of the table is no choice here
}

void ImportTable::showColumn(std::size_t index) {
    const devices::CsvColumn& column = m_columns[index];
    const Said& said = m_said[index];
    const QString word = theirs(m_columns, index);
    const bool isTime = m_time == index;
    const int at = static_cast<int>(index) + m_shift;
    QTableWidgetItem& name =
        showCell(NameRow, at, isTime ? tr("time") : chosen(said.name, QString::fromStdString(column.signal)),
                 Qt::AlignLeft);
    dress(name, tr("Name of column %1").arg(word), !said.name.isEmpty(),
          isTime ? tr("Choose the time column above")
                 : tr("Signal name of this column in the recording (F2 edits)"));
    QTableWidgetItem& unit =
        showCell(UnitRow, at, chosen(said.unit, QString::fromStdString(column.written)), Qt::AlignLeft);
    dress(unit, tr("Unit of column %1").arg(word), !said.unit.isEmpty(),
          tr("Unit of the numbers, e.g. rpm or mA; hyphen: no unit"));
    setEditable(name, !isTime);
    setEditable(unit, true);
}

QTableWidgetItem& ImportTable::showCell(int row, int column, const QString& text, Qt::Alignment alignment) {
    QTableWidgetItem* cell = item(row, column);
    if (cell == nullptr) {
        cell = new QTableWidgetItem;
        cell->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        setItem(row, column, cell);
    }
    cell->setText(text);
    cell->setTextAlignment(static_cast<int>(alignment | Qt::AlignVCenter));
    return *cell;
}

void ImportTable::onItem(const QTableWidgetItem& item) {
    const int index = item.column() - m_shift;
    if (item.row() >= firstRow() || index < 0) {
        return;
    }
    Said& said = m_said[static_cast<std::size_t>(index)];
    (item.row() == NameRow ? said.name : said.unit) = item.text().trimmed();
    Q_EMIT changed();
}

void ImportTable::keyPressEvent(QKeyEvent* event) {
    QTableWidgetItem* cell = currentItem();
    if (event->key() == Qt::Key_Delete && cell != nullptr && (cell->flags() & Qt::ItemIsEditable) != 0) {
        cell->setText(QString());
        return;
    }
    QTableWidget::keyPressEvent(event);
}

void ImportTable::addTo(devices::CsvImportRequest& request) const {
    for (std::size_t i = 0; i < m_said.size(); ++i) {
        const std::string word = devices::columnWord(m_columns, i);
        if (m_time != i && !m_said[i].name.isEmpty()) {
            request.map.emplace_back(m_said[i].name.toStdString(), word);
        }
        if (!m_said[i].unit.isEmpty()) {
            request.units.emplace_back(word, m_said[i].unit.toStdString());
        }
    }
}

void ImportTable::take(const devices::CsvQuestion::Answer& answer) {
    for (std::size_t i = 0; i < m_said.size(); ++i) {
        if (!answer.unit.first.empty() && devices::columnWord(m_columns, i) == answer.unit.first) {
            m_said[i].unit = QString::fromStdString(answer.unit.second);
        }
    }
}

} // namespace halbench::app
