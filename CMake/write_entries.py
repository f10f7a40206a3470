#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes ParaView's XML from headers: a parameter's meaning, unit, range and default stand there alone.

Usage: write_entries.py <source folder> <folder to write to> <class>,<class>... <template>...

A template, Plugin/Views/*.xml.in, is ParaView's XML with these elements besides:

    <Parameters names="A B"/>  properties for SetA() and SetB() of the proxy's class or its bases. "*" is each
                               that the proxy does not name, of its class and bases that its base proxy lacks,
                               but for those of except. Further attributes go to the properties; but min, max,
                               texts and documentation replace what the header says, note is a sentence more,
                               and visible_if="Other=1" asks for values of other properties.
    <Input name="" type=""/>   an input of a kind of data; optional="1", and domain for the domain's name
    <Properties of="proxy"/>   the names of all properties of a part of the view, but for those of except
    <Proxies of="group"/>      all proxies of a group, to choose from
    <Texts of="Class::Enum"/>  what ParaView shows in place of an enumeration's constants

The attribute prefix of a proxy goes before the names of its properties. Each class of the list has to have a
proxy. Prints the files that it has read. What a header does not say is an error with its place and remedy.
"""

import pathlib
import re
import sys
import types
import xml.etree.ElementTree as ElementTree

MOST_CHARACTERS = 440  # of a property's documentation, in whole sentences, as it is shown as a tooltip
SCALAR_TYPES = {"VTK_FLOAT": 10, "VTK_DOUBLE": 11}
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?(?: ?/ ?\d+(?:\.\d+)?)?"
ENUM = r"one of (?:(vtk\w+)::)?([A-Z]\w*(?:Type|Mode))"
MACRO = r"vtk(Set|Get)(?:Clamp|Vector(\d))?Macro\((\w+), (\w+)(?:, (.+), (.+))?\);"
SETTER = r"void (?:Set|(?=Load))(\w+)\((?:const )?(int|double|bool) \w+(?:\[(\d)\])?((?:, \2 \w+)*)\)"


def stop(place, problem, remedy):
    sys.exit(f"{place}: {problem} {remedy}")


def split_words(name):
    """Number Of Samples for NumberOfSamples, as ParaView has it."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)


def show(number):
    """A number as short as it can be."""
    return repr(int(number) if number == int(number) and abs(number) < 1e10 else float(number))


class Header:
    """A class as its header declares it."""
    def __init__(self, path):
        self.path, self.name = path, path.stem
        code = path.read_text(encoding="utf-8")
        self.base = "".join(re.findall(rf"class \w+ {self.name}\s*: public (\w+)", code))
        self.brief = "".join(re.findall(r"@brief\s+(.*)", code))
        self.members = dict(re.findall(r"^ +(?:bool|int|double) (\w+)(?:\[\d\])? = (.*?);", code, re.M))
        self.enums, self.parameters = {}, {}
        for name, body in re.findall(r"^  enum (\w+)\n  \{\n(.*?)^  \};", code, re.M | re.S):
            if "vtkGodRaysPhaseFunctionConstantsMacro" in body:
                self.enums[name] = [(constant, int(number), "") for constant, number, _ in PHASE_FUNCTIONS]
            else:
                found = re.findall(r"(\w+) =\s+(\d+),?(?: *///< (.*))?", body)
                self.enums[name] = [(constant, int(value), text) for constant, value, text in found]
        for found in re.finditer(r"/\*\*\n((?:   \*.*\n)+?)   \*/\n((?: .*\n)+)", code):
            text = " ".join(re.sub(r"^ *\* ?", "", found[1], flags=re.M).split())
            self.find_parameters(text, found[2], code.count("\n", 0, found.start(2)) + 1)

    def find_parameters(self, text, code, line):
        """Takes what a comment and the declarations under it say of SetName() and GetName()."""
        group = []
        for number, each in enumerate(code.splitlines(), line):
            macro = re.search(MACRO, each)
            getter = re.search(r"(int|double|bool)\*? Get(\w+)\(\)", each)
            setter = re.search(SETTER, each)
            if macro:
                verb, size, name, kind, *limits = macro.groups()
            elif getter:
                verb, size, (kind, name) = "Get", 1, getter.groups()
            elif setter:
                verb, name, kind = "Set", setter[1], setter[2]
                size = setter[3] or 1 + setter[4].count(",")
            else:
                continue
            parameter = self.parameters.setdefault(name, types.SimpleNamespace(name=name, text=text,
                place=f"{self.path}:{number}", group=group, is_set=False, is_read=False))
            parameter.is_read |= verb == "Get"
            if not parameter.is_set:
                parameter.kind, parameter.size, parameter.is_set = kind, int(size or 1), verb == "Set"
                parameter.type = "Double" if kind == "double" else "Int"
                parameter.limits = limits if macro and limits[0] else []
                group += [parameter] * parameter.is_set


def read_header(name):
    if name not in HEADERS:
        HEADERS[name] = Header(PATHS[name])
    return HEADERS[name]


def chain(name, end=""):
    """The headers of a class and its bases, before one that is not ours, or the given one."""
    found = []
    while name in PATHS and name != end:
        found.append(read_header(name))
        name = found[-1].base
    return found


def find_text(header, enum, constant):
    """What is shown of a constant: Low sun of LOW_SUN, if nothing else is said."""
    text = constant.replace("_", " ").capitalize()
    return TEXTS.get((header.name, enum, constant)) or TEXTS.get(constant, text)


class Properties:
    """The properties of a proxy, from the headers of its class."""
    def __init__(self, place, proxy, end):
        self.place, self.prefix, self.name = place, proxy.attrib.pop("prefix", ""), proxy.get("class")
        self.chain, own = chain(self.name), chain(self.name, end)
        self.all = {}
        for header in reversed(self.chain):
            self.all.update(header.parameters)
        elements = list(proxy.iter("Parameters"))
        named = {name for each in elements for name in each.get("names").split()}
        left_out = {name for each in elements for name in each.get("except", "").split()}
        self.exposed = set(self.all) - left_out
        self.others = dict.fromkeys(name for header in own for name, each in header.parameters.items()
            if each.is_set and each.is_read and name not in named | left_out)

    def make(self, element):
        """The properties that an element <Parameters/> stands for."""
        hints = {key: value for key, value in element.attrib.items() if key not in ("names", "except")}
        return [self.make_one(each, dict(hints)) for name in element.get("names").split()
            for each in (self.others if name == "*" else [name])]

    def make_one(self, name, hints):
        if name not in self.all:
            stop(self.place, f"{self.name} has no Set{name}() with a comment.",
                "Write it, of bool, int or double, or take the name out.")
        parameter = self.all[name]
        is_output = "information_only" in hints
        attributes = {"name": self.prefix + name, "command": ("Get" if is_output else "Set") + name}
        if not is_output:
            attributes["number_of_elements"] = str(parameter.size)
            attributes["default_values"] = hints.pop("default_values", "") or self.find_default(parameter)
        text = (hints.pop("documentation", "") or self.describe(parameter)) + hints.pop("note", "")
        conditions = hints.pop("visible_if", "").split()
        domains = [] if is_output else self.make_domains(parameter, hints)
        made = ElementTree.Element(f"{parameter.type}VectorProperty", {**attributes, **hints})
        made.extend(domains)
        ElementTree.SubElement(made, "Documentation").text = text.strip()
        parent = ElementTree.SubElement(made, "Hints") if conditions else None
        for other, value in (each.split("=") for each in conditions):
            ElementTree.SubElement(parent, "PropertyWidgetDecorator", {
                "type": "GenericDecorator", "mode": "visibility", "property": other, "value": value})
        return made

    def evaluate(self, text):
        """The number that a text of C++ stands for, or None."""
        if re.fullmatch(NUMBER, text.strip()):
            above, _, below = text.partition("/")
            return float(above) / float(below or 1)
        words = {"true": 1, "false": 0, "on": 1, "off": 0, **SCALAR_TYPES,
            "vtkGodRaysLastPhaseFunction": len(PHASE_FUNCTIONS) - 1}
        for header in (read_header("vtkGodRaysAtmosphere"), *reversed(self.chain)):
            words.update((each[0], each[1]) for constants in header.enums.values() for each in constants)
        return words.get(text.strip())

    def find_default(self, parameter):
        """The default values: those of the member, with which the comment has to agree."""
        name, told = parameter.name, []
        mine = re.search(rf"of a {self.name} ({NUMBER})", parameter.text)
        if mine:
            return show(self.evaluate(mine[1]))
        member = next((each.members[name] for each in self.chain if name in each.members), "")
        values = [self.evaluate(each) for each in member.strip("{} ").split(",")] if member else []
        found = re.search(r"\bDefaults?(?: is| are|:) (.*?)(?:, [a-z]|[:;]|\.(?: |$))", parameter.text)
        parts = re.findall(rf"\(.*?\)|\bo(?:n|ff)\b|\b[A-Z][A-Z_0-9]+\b|{NUMBER}", found[1]) if found else []
        if parts and len(parts) == len(parameter.group):
            told = parts[parameter.group.index(parameter)].strip("()").split(",")
            told = [self.evaluate(each) for each in told]
            told *= parameter.size if len(told) == 1 else 1
        if values and told and told != values:
            stop(parameter.place, f"the default of {name} is {told} in the comment, {values} in the member.",
                f"Correct one; or, if the constructor sets another, write default_values into {self.place}.")
        values = values or told
        if not values or None in values:
            stop(parameter.place, f"Set{name}() has no default.",
                'Write "Default is <number>." into its comment, or initialise the member.')
        return " ".join(show(each) for each in values)

    def find_choices(self, parameter):
        """(value, text, meaning) of each constant that a parameter takes; empty if it takes numbers."""
        found = re.search(ENUM, parameter.text)
        if not found:
            return [(value, name[4:].capitalize(), "") for name, value in SCALAR_TYPES.items()
                if re.search(rf"\b{name}\b", parameter.text)]
        header = next((each for each in chain(found[1] or self.name) if found[2] in each.enums), None)
        if not header:
            stop(parameter.place, f"there is no enumeration {found[2]}.", "Declare it in the class.")
        first, last = map(self.evaluate, parameter.limits or ["0", "1e9"])
        return [(value, find_text(header, found[2], constant), text)
            for constant, value, text in header.enums[found[2]] if first <= value <= last]

    def make_domains(self, parameter, hints):
        choices = self.find_choices(parameter)
        if parameter.kind == "bool":
            return [ElementTree.Element("BooleanDomain", {"name": "bool"})]
        if choices:
            texts = hints.pop("texts", ";".join(each[1] for each in choices)).split(";")
            domain = ElementTree.Element("EnumerationDomain", {"name": "enum"})
            for (value, _, _), text in zip(choices, texts):
                ElementTree.SubElement(domain, "Entry", {"text": text.strip(), "value": str(value)})
            return [domain]
        useful, found = (re.search(rf"\b{each} range: \[([^],]+), ([^],]+)\](, and 0)?", parameter.text)
            for each in ("Useful", "Valid"))  # sliders go over the former; any valid number may be typed
        ends = [*useful.groups()[:2]] if useful else parameter.limits or (
            ["0" if found[3] else found[1], found[2]] if found else [])
        ends = [hints.pop(each) for each in ("min", "max")] if "min" in hints else [
            show(self.evaluate(each)) for each in ends]
        if not ends and "of any length" in parameter.text:
            return []  # a direction
        if not ends:
            stop(parameter.place, f"Set{parameter.name}() has no range that can be read.",
                'Write "Valid range: [<low>, <high>]." or "one of <enumeration>" into a comment of its own.')
        low, high = (end if " " in end else " ".join([end] * parameter.size) for end in ends)
        return [ElementTree.Element(
            f"{parameter.type}RangeDomain", {"name": "range", "min": low, "max": high})]

    def describe(self, parameter):
        """A parameter's comment for users; range and default, which ParaView shows, are left out."""
        comment = re.sub(rf"^(?:Set/Get|Set) |, {ENUM}", "", parameter.text)
        text = ""
        for sentence in re.split(r"(?<=\.)\s+(?=[A-Z0-9(]|vtk)", comment[:1].upper() + comment[1:]):
            if re.match(r"Valid |Useful |Any finite|Defaults?\b|Others are|Any other", sentence):
                continue
            sentence = self.translate(sentence)
            if not text and not sentence:
                stop(parameter.place, f"the first sentence about {parameter.name} is not for users.",
                    "Name functions, files and classes of C++ in further sentences.")
            if sentence and len(text) + len(sentence) <= MOST_CHARACTERS:
                text += f"{sentence} "
        meanings = ((shown, self.translate(each)) for _, shown, each in self.find_choices(parameter))
        return text + "".join(f"{shown}: {meaning}. " for shown, meaning in meanings if meaning)

    def translate(self, sentence):
        """A sentence with names of C++ as labels; empty if it is about programming."""
        sentence = re.sub(r"\b(?:an? )?(vtkGodRays(\w+)(Model|Integrator))\b(?!::)", lambda found:
            f"the {found[3].lower()} {LABELS.get(found[1], split_words(found[2]))}", sentence)
        sentence = re.sub(r"\bvtkGodRaysPass\b(?!::)", "the view", sentence)
        sentence = re.sub(r"\bvtkGodRays\w+::(\w+)\b(?!\()", r"\1", sentence)
        if re.search(r"\bvtk[A-Z]|\w\(\)|\bDocumentation/|\bNaN\b", sentence):
            return ""
        return re.sub(r"\b[A-Z]\w+\b", self.label, sentence)

    def label(self, found):
        """What a user sees in place of a name in a sentence, if it is that of a constant or a parameter."""
        name, words = found[0], split_words(found[0])
        if name in CONSTANTS:
            return f'"{CONSTANTS[name]}"' if " " in CONSTANTS[name] else CONSTANTS[name]
        if name in self.exposed and (found.start() > 0 or words != name):
            return split_words(self.prefix + name)
        return words if name in PARAMETERS else name


def make_input(element):
    """An input of a kind of data; the text of the element tells what it is."""
    hints = {"domain": "input_type", "optional": "", **element.attrib}
    kind, domain, optional = (hints.pop(each) for each in ("type", "domain", "optional"))
    made = ElementTree.fromstring(f"""<InputProperty command="SetInputConnection">
        <ProxyGroupDomain name="groups"><Group name="sources"/><Group name="filters"/></ProxyGroupDomain>
        <DataTypeDomain name="{domain}"><DataType value="{kind}"/></DataTypeDomain>
        <Documentation>{" ".join(element.text.split())}</Documentation>
        {"<Hints><Optional/></Hints>" if optional else ""}</InputProperty>""")
    made.attrib.update(hints)
    made.extend(element)
    return [made]


def replace(root, makers):
    """Replaces elements by those that the function for their tag makes of them."""
    for parent in list(root.iter()):
        for element in [each for each in parent if each.tag in makers]:
            place = list(parent).index(element)
            parent[place:place + 1] = makers[element.tag](element)


def expose(element, proxies):
    """<Property/> for each property of a part of the view, and of its own parts."""
    made = []
    for each in proxies["godrays_parts", element.get("of")][1].iter():
        if each.tag == "Properties":
            made += expose(each, proxies)
        elif each.tag.endswith("Property") and each.get("name") not in element.get("except", "").split():
            made.append(ElementTree.Element("Property", {"name": each.get("name")}))
    return made


def main(folder, classes, *templates):
    roots = {path: ElementTree.parse(path).getroot() for path in map(pathlib.Path, templates)}
    for path, root in roots.items():
        for element in root.findall("Texts"):
            name, enum = element.get("of").split("::")
            constants, texts = read_header(name).enums[enum], element.text.split(";")
            if len(constants) != len(texts):
                stop(path, f"{name}::{enum} has {len(constants)} constants, and {len(texts)} texts.",
                    "Write one for each, with semicolons between.")
            TEXTS.update({(name, enum, each[0]): text.strip() for each, text in zip(constants, texts)})
            root.remove(element)
    proxies = {(group.get("name"), proxy.get("name")): (path, proxy) for path, root in roots.items()
        for group in root for proxy in group}
    LABELS.update({proxy.get("class"): proxy.get("label", "") for _, proxy in proxies.values()})
    for name in filter(None, classes.split(",")):
        if name not in LABELS:
            stop(PATHS[name], f"{name} is not in ParaView.", "Write a proxy of this class, with "
                f'<Parameters names="*"/>, into a template beside {templates[0]}.')
    for _, proxy in proxies.values():
        for header in chain(proxy.get("class")):
            PARAMETERS.update(proxy.get("prefix", "") + name for name in header.parameters)
            CONSTANTS.update((each[0], find_text(header, enum, each[0]))
                for enum, constants in header.enums.items() for each in constants)
    for path, proxy in proxies.values():
        _, base = proxies.get((proxy.get("base_proxygroup"), proxy.get("base_proxyname")), (None, {}))
        properties = Properties(path, proxy, base.get("class", ""))
        for help_of in proxy.findall("Documentation") if proxy.tag == "SourceProxy" else []:
            brief = properties.translate(properties.chain[0].brief)
            for key, end in (("short_help", ""), ("long_help", ".")):
                help_of.attrib.setdefault(key, brief[:1].upper() + brief[1:] + end)
        replace(proxy, {"Parameters": properties.make, "Input": make_input})
    for path, root in roots.items():
        replace(root, {"Properties": lambda element: expose(element, proxies),
            "Proxies": lambda element: [ElementTree.Element("Proxy", {"group": group, "name": name})
                for group, name in proxies if group == element.get("of")]})
        ElementTree.indent(root)
        text = ElementTree.tostring(root) + b"\n"
        result = pathlib.Path(folder, path.name.removesuffix(".in"))
        if not result.exists() or result.read_bytes() != text:
            result.write_bytes(text)
    print(PATHS["vtkGodRaysPhaseFunction"], *(header.path for header in HEADERS.values()), sep="\n")


PATHS = {path.stem: path for part in ("Filters", "Rendering", "Plugin")
    for path in sorted(pathlib.Path(sys.argv[1], part).rglob("vtkGodRays*.h"))}
PHASE_FUNCTIONS = re.findall(r'Each\(([A-Z_]+), (\d+), "(.*?)"',
    PATHS["vtkGodRaysPhaseFunction"].read_text(encoding="utf-8"))
TEXTS = {constant: name[0].upper() + name[1:] for constant, _, name in PHASE_FUNCTIONS}
CONSTANTS = {each: each[4:].lower() for each in SCALAR_TYPES}  # what is shown of them in sentences
HEADERS, LABELS, PARAMETERS = {}, {}, set()
main(*sys.argv[2:])
