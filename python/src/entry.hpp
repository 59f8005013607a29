#pragma once
#include "convert.hpp"
#include <pybind11/stl.h>

namespace prelight::python {

/// One object of a list of a scene or world, or one by itself. It keeps its owner and its number, and no address:
/// lists may grow, and a scene that a world refers to is copied before it changes (SceneBox).
template <class T>
class Entry {
public:
    /// `edit`: what is returned will be changed.
    using List = std::vector<T>& (*)(void* owner, bool edit);
    explicit Entry(T own) : own_(std::make_shared<T>(std::move(own))) {}
    Entry(std::shared_ptr<void> owner, List list, size_t index)
        : owner_(std::move(owner)), list_(list), index_(index) {}

    const T& get() const { return own_ ? *own_ : at(false); }
    T& edit() { return own_ ? *own_ : at(true); }
    /// Throws UsageError: in another list, or in none.
    uint32_t index_in(const void* owner, const char* what) const {
        if (owner_.get() != owner)
            throw UsageError(std::string(what) + " is not of this scene: add it first");
        at(false);
        return uint32_t(index_);
    }
    const std::shared_ptr<void>& owner() const { return owner_; }
    template <class Owner>
    const Owner& owner_as() const {
        return *static_cast<const Owner*>(owner_.get());
    }
    std::optional<size_t> index() const { return own_ ? std::nullopt : std::optional(index_); }

private:
    T& at(bool edit) const {
        std::vector<T>& list = list_(owner_.get(), edit);
        if (index_ >= list.size())
            throw py::index_error("it is no longer in its list");
        return list[index_];
    }
    std::shared_ptr<T> own_;
    std::shared_ptr<void> owner_;
    List list_ = nullptr;
    size_t index_ = 0;
};

template <class T>
struct Entries {
    std::shared_ptr<void> owner;
    typename Entry<T>::List list;
    const std::vector<T>& get() const { return list(owner.get(), false); }
    std::vector<T>& edit() const { return list(owner.get(), true); }
    Entry<T> at(py::ssize_t index) const {
        const auto count = py::ssize_t(get().size());
        if (index < -count || index >= count)
            throw py::index_error("there are " + std::to_string(count));
        return Entry<T>(owner, list, size_t(index < 0 ? index + count : index));
    }
};

/// A list of the class `element` of T.
template <class T>
py::class_<Entries<T>> bind_entries(py::module_& module, const char* name, const char* doc) {
    py::class_<Entries<T>> made(module, name, doc);
    const auto all = [](const Entries<T>& entries) {
        py::list listed;
        for (size_t i = 0; i < entries.get().size(); ++i)
            listed.append(py::cast(entries.at(py::ssize_t(i))));
        return listed;
    };
    made.def("__len__", [](const Entries<T>& entries) { return entries.get().size(); });
    made.def("__getitem__", &Entries<T>::at, py::arg("index"));
    made.def(
        "__getitem__",
        [all](const Entries<T>& entries, const py::slice& slice) -> py::list { return all(entries)[slice]; },
        py::arg("index"));
    made.def("__iter__", [all](const Entries<T>& entries) { return py::iter(all(entries)); });
    made.def("__repr__", [all](const Entries<T>& entries) { return py::repr(all(entries)); });
    return made;
}

/// What of a list, or of any iterable of such entries, is there now. Throws TypeError.
template <class T>
std::vector<T> copies_of(const py::object& given) {
    if (py::isinstance<Entries<T>>(given))
        return given.cast<const Entries<T>&>().get();
    std::vector<T> copies;
    for (const py::handle each : py::iter(given))
        if (py::isinstance<Entry<T>>(each))
            copies.push_back(each.cast<const Entry<T>&>().get());
        else
            throw py::type_error("a " + py::type::of<Entry<T>>().attr("__name__").template cast<std::string>() +
                                 " is needed, not " + shape_of(py::reinterpret_borrow<py::object>(each)));
    return copies;
}

/// The same with what a list of its own can do besides.
template <class T>
py::class_<Entries<T>> bind_editable_entries(py::module_& module, const char* name, const char* doc) {
    py::class_<Entries<T>> made = bind_entries<T>(module, name, doc);
    made.def(
        "__setitem__",
        [](Entries<T>& entries, py::ssize_t index, const Entry<T>& value) {
            T copy = value.get();
            entries.at(index).edit() = std::move(copy);
        },
        py::arg("index"), py::arg("value"));
    made.def(
        "__delitem__",
        [](Entries<T>& entries, py::ssize_t index) {
            const size_t at = *entries.at(index).index();
            entries.edit().erase(entries.edit().begin() + py::ssize_t(at));
        },
        py::arg("index"));
    made.def(
        "append",
        [](Entries<T>& entries, const Entry<T>& value) {
            T copy = value.get();
            entries.edit().push_back(std::move(copy));
            return entries.at(-1);
        },
        py::arg("value"), "Adds a copy, and returns the one in the list.");
    made.def(
        "extend",
        [](Entries<T>& entries, const py::object& values) {
            std::vector<T> more = copies_of<T>(values);
            std::vector<T>& list = entries.edit();
            list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
        },
        py::arg("values"), "Adds copies.");
    made.def("clear", [](Entries<T>& entries) { entries.edit().clear(); });
    return made;
}

/// A property of an entry. `get`: from T& (const or not) to a reference to the member.
template <class T, class Get>
void field(py::class_<Entry<T>>& made, const char* name, Get get, const char* doc) {
    using Member = std::decay_t<decltype(get(std::declval<T&>()))>;
    made.def_property(
        name, [get](const Entry<T>& entry) -> Member { return get(entry.get()); },
        [get](Entry<T>& entry, Member value) { get(entry.edit()) = std::move(value); }, doc);
}
template <class T, class Get>
void vector_field(py::class_<Entry<T>>& made, const char* name, Get get, const char* doc) {
    using Vector = std::decay_t<decltype(get(std::declval<T&>()))>;
    made.def_property(
        name, [get](const Entry<T>& entry) { return from_vector<Vector>(get(entry.get())); },
        [get, name](Entry<T>& entry, const ArrayLike& given) {
            const auto value = to_vector<Vector>(given, name);
            get(entry.edit()) = value;
        },
        doc);
}

} // namespace prelight::python
