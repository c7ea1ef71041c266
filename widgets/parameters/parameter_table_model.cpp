#include "widgets/parameters/parameter_table_model.h"

#include "widgets/language/phrasebook.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::widgets {

/// Shows the values before or after; what was shown is kept, not how it differed from the device, so that
/// undoing a written edit proposes the old value.
class ParameterEditCommand : public QUndoCommand {
public:
    ParameterEditCommand(ParameterTableModel& model, std::vector<ParameterTableModel::Change> changes,
                         const QString& text)
        : QUndoCommand(text), m_model(model), m_changes(std::move(changes)) {}
    void undo() override {
        for (const auto& change : m_changes) {
            m_model.show(change.row, change.before);
        }
    }
    void redo() override {
        for (const auto& change : m_changes) {
            m_model.show(change.row, change.after);
        }
    }

private:
    ParameterTableModel& m_model;
    std::vector<ParameterTableModel::Change> m_changes;
};

QStringList choicesOf(const ParameterSpec& spec) {
    QStringList words;
    for (const std::string& choice : spec.choices) {
        words << inWords(choice);
    }
    if (words.isEmpty() && spec.isInteger && spec.min == 0.0 && spec.max == 1.0) {
        words << ParameterTableModel::tr("off") << ParameterTableModel::tr("on");
    }
    return words;
}

ParameterTableModel::ParameterTableModel(QObject* parent) : QAbstractItemModel(parent) {}

void ParameterTableModel::setSpecs(std::vector<ParameterSpec> specs) {
    beginResetModel();
    m_undo.clear();
    m_rows.clear();
    m_groups.clear();
    for (ParameterSpec& spec : specs) {
        const QString title = spec.group.empty() ? tr("Other") : inWords(spec.group);
        auto group = std::find_if(m_groups.begin(), m_groups.end(),
                                  [&title](const Group& known) { return known.title == title; });
        if (group == m_groups.end()) {
            group = m_groups.insert(m_groups.end(), Group{title, {}});
        }
        group->rows.push_back(m_rows.size());
        m_rows.push_back({std::move(spec), {}, {}, {}});
    }
    endResetModel();
    announceCount();
}

void ParameterTableModel::setDeviceValues(const std::vector<ParameterValue>& values, Origin origin) {
    if (m_isStale) {
        setStale(false);
    }
    for (const ParameterValue& value : values) {
        const auto at = findRow(value.name);
        if (!at) {
            continue;
        }
        Row& row = m_rows[*at];
        const bool isNews = row.device && !areSameOnBoard(*row.device, value.value);
        const bool isSeen = row.device == value.value && (origin == Origin::Read || !row.beforeOutsideChange);
        const bool isDone = row.edited && areSameOnBoard(*row.edited, value.value);
        if (isSeen && !isDone) {
            continue; // read again and again, nothing to say
        }
        if (origin == Origin::Written) {
            row.beforeOutsideChange.reset();
        } else if (isNews) {
            row.beforeOutsideChange = row.device;
        }
        row.device = value.value;
        if (isDone) {
            row.edited.reset();
        }
        announce(*at);
    }
    announceCount();
}

void ParameterTableModel::announceCount() {
    if (std::exchange(m_announcedCount, changedCount()) != changedCount()) {
        Q_EMIT changedCountChanged(changedCount());
    }
}

void ParameterTableModel::setStale(bool isStale) {
    if (std::exchange(m_isStale, isStale) == isStale) {
        return;
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        announce(i);
    }
}

void ParameterTableModel::setAngleUnit(AngleUnit unit) {
    m_angleUnit = unit;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        announce(i);
    }
}

std::vector<ParameterValue> ParameterTableModel::changedValues() const {
    std::vector<ParameterValue> changed;
    for (const Row& row : m_rows) {
        if (row.edited) {
            changed.push_back({row.spec.name, *row.edited});
        }
    }
    return changed;
}

int ParameterTableModel::changedCount() const {
    return static_cast<int>(
        std::count_if(m_rows.begin(), m_rows.end(), [](const Row& row) { return row.edited.has_value(); }));
}

Result<void> ParameterTableModel::edit(const std::string& name, double value) {
    const auto row = findRow(name);
    if (!row) {
        return failure(ErrorCode::UnknownName, "There is no parameter '" + name + "'.");
    }
    return editRow(*row, value, shownValue(m_rows[*row], value));
}

Result<void> ParameterTableModel::editRow(std::size_t at, std::optional<double> value, const QString& typed) {
    const Row& row = m_rows[at];
    const auto verdict = checkParameterValue(row.spec, value.value_or(std::nan("")));
    if (!verdict) {
        refuse(row, verdict.error(), typed, value);
        return verdict;
    }
    const auto shown = row.edited ? row.edited : row.device;
    if (!shown || *shown != *value) {
        push({{at, shown, value}}, tr("edit of %1").arg(QString::fromStdString(row.spec.name)));
    }
    return {};
}

void ParameterTableModel::refuse(const Row& row, const Error& error, const QString& typed,
                                 std::optional<double> value) {
    const QString name = QString::fromStdString(row.spec.name);
    const QString range =
        tr("Allowed: %1 to %2.").arg(shownValue(row, row.spec.min), shownValue(row, row.spec.max));
    if (error.code == ErrorCode::DeviceRefused) {
        Q_EMIT editRefused(name, tr("%1 is read-only.").arg(name), {}, std::nullopt);
        return;
    }
    if (!value) {
        Q_EMIT editRefused(name, tr("%1: “%2” is not a number.").arg(name, typed), range, std::nullopt);
        return;
    }
    const double nearest = std::clamp(*value, row.spec.min, row.spec.max);
    const bool needsWhole = row.spec.isInteger && nearest == *value;
    Q_EMIT editRefused(name,
                       needsWhole ? tr("%1 must be a whole number, not %2.").arg(name, typed)
                                  : tr("%1: %2 is outside its limits.").arg(name, typed),
                       range, row.spec.isInteger ? std::round(nearest) : nearest);
}

void ParameterTableModel::push(std::vector<Change> changes, const QString& text) {
    if (!changes.empty()) {
        m_undo.push(new ParameterEditCommand(*this, std::move(changes), text)); // the stack owns it
    }
}

void ParameterTableModel::show(std::size_t at, std::optional<double> value) {
    Row& row = m_rows[at];
    row.edited = value && row.device && areSameOnBoard(*value, *row.device) ? std::nullopt : value;
    announce(at);
    announceCount();
}

void ParameterTableModel::revert() {
    std::vector<Change> changes;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].edited) {
            changes.push_back({i, m_rows[i].edited, m_rows[i].device});
        }
    }
    push(std::move(changes), tr("revert"));
}

void ParameterTableModel::editToDefaults() {
    std::vector<Change> changes;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const Row& row = m_rows[i];
        const auto shown = row.edited ? row.edited : row.device;
        if (checkParameterValue(row.spec, row.spec.defaultValue) &&
            (!shown || !areSameOnBoard(*shown, row.spec.defaultValue))) {
            changes.push_back({i, shown, row.spec.defaultValue});
        }
    }
    push(std::move(changes), tr("defaults"));
}

void ParameterTableModel::acknowledgeOutsideChanges() {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].beforeOutsideChange) {
            m_rows[i].beforeOutsideChange.reset();
            announce(i);
        }
    }
}

std::optional<std::size_t> ParameterTableModel::findRow(const std::string& name) const {
    const auto found =
        std::find_if(m_rows.begin(), m_rows.end(), [&name](const Row& row) { return row.spec.name == name; });
    return found == m_rows.end() ? std::nullopt
                                 : std::optional(static_cast<std::size_t>(found - m_rows.begin()));
}

const ParameterTableModel::Row* ParameterTableModel::rowAt(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == 0) {
        return nullptr;
    }
    return &m_rows[m_groups[index.internalId() - 1].rows[static_cast<std::size_t>(index.row())]];
}

const ParameterSpec* ParameterTableModel::specAt(const QModelIndex& index) const {
    const Row* row = rowAt(index);
    return row == nullptr ? nullptr : &row->spec;
}

QModelIndex ParameterTableModel::indexOf(const std::string& name) const {
    const auto at = findRow(name);
    for (std::size_t g = 0; at && g < m_groups.size(); ++g) {
        const auto& rows = m_groups[g].rows;
        const auto found = std::find(rows.begin(), rows.end(), *at);
        if (found != rows.end()) {
            return createIndex(static_cast<int>(found - rows.begin()), EditedColumn, g + 1);
        }
    }
    return {};
}

void ParameterTableModel::announce(std::size_t row) {
    const QModelIndex cell = indexOf(m_rows[row].spec.name);
    Q_EMIT dataChanged(cell.siblingAtColumn(NameColumn), cell.siblingAtColumn(MaxColumn));
}

// An index of a group has the id 0, one of a parameter that of its group plus one.
QModelIndex ParameterTableModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) {
        return {};
    }
    return parent.isValid() ? createIndex(row, column, static_cast<quintptr>(parent.row()) + 1)
                            : createIndex(row, column, quintptr(0));
}

QModelIndex ParameterTableModel::parent(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == 0) {
        return {};
    }
    return createIndex(static_cast<int>(index.internalId()) - 1, 0, quintptr(0));
}

int ParameterTableModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) {
        return static_cast<int>(m_groups.size());
    }
    const bool isGroup = parent.internalId() == 0 && parent.column() == 0;
    return isGroup ? static_cast<int>(m_groups[static_cast<std::size_t>(parent.row())].rows.size()) : 0;
}

int ParameterTableModel::columnCount(const QModelIndex&) const {
    return Columns;
}

bool ParameterTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const Row* row = rowAt(index);
    if (row == nullptr || role != Qt::EditRole || index.column() != EditedColumn) {
        return false;
    }
    const QStringList choices = choicesOf(row->spec);
    const DisplayUnit unit = displayUnit(row->spec.unit, m_angleUnit);
    const QString typed = value.toString();
    std::optional<double> number = parseNumber(typed, unit.text);
    if (const auto choice = choices.indexOf(typed); choice >= 0) {
        number = static_cast<double>(choice);
    } else if (number) {
        // Opening and closing an editor changes nothing: what it showed stands for the value itself.
        const auto shown = row->edited ? row->edited : row->device;
        number = shown && typed == data(index, Qt::EditRole).toString() ? *shown : *number / unit.factor;
    }
    return editRow(*findRow(row->spec.name), number, typed).has_value();
}

Qt::ItemFlags ParameterTableModel::flags(const QModelIndex& index) const {
    const Row* row = rowAt(index);
    if (row == nullptr) {
        return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::NoItemFlags;
    }
    const bool isEditable = index.column() == EditedColumn && row->spec.access == ParameterAccess::ReadWrite;
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return isEditable ? flags | Qt::ItemIsEditable : flags;
}

} // namespace halbench::widgets
