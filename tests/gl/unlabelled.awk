# Reads what `apitrace dump` writes; lists the objects that were created and not labelled, and ends with 1 if there are any.
BEGIN {
    kinds["Textures"] = "GL_TEXTURE"; kinds["Buffers"] = "GL_BUFFER"; kinds["Framebuffers"] = "GL_FRAMEBUFFER"
    kinds["VertexArrays"] = "GL_VERTEX_ARRAY"; kinds["Samplers"] = "GL_SAMPLER"; kinds["Queries"] = "GL_QUERY"
    kinds["Program"] = "GL_PROGRAM"; kinds["Shader"] = "GL_SHADER"
}

function created(kind, name) {
    open_[kind " " name] = $0
    ++made[kind]
}

function number(text, from) {
    sub(from, "", text)
    return text + 0
}

/^[0-9]+ gl(Gen|Create)[A-Z]/ {
    call = $2
    sub(/^gl(Gen|Create)/, "", call)
    sub(/\(.*/, "", call)
    if (!(call in kinds)) next
    if (call == "Program" || call == "Shader") {
        created(kinds[call], $NF + 0)
        next
    }
    names = $0
    sub(/.*= [&{]+/, "", names)
    count = split(names, each, ", ")
    for (i = 1; i <= count; ++i) created(kinds[call], number(each[i], "^&"))
}

/^[0-9]+ glObjectLabel\(/ {
    kind = $0; sub(/.*identifier = /, "", kind); sub(/,.*/, "", kind)
    name = $0; sub(/.*name = /, "", name); sub(/,.*/, "", name)
    if (!((kind " " name) in open_)) next
    delete open_[kind " " name]
    ++labelled[kind]
}

END {
    for (kind in made) printf "%-16s %3d created, %3d labelled\n", kind, made[kind], labelled[kind]
    for (name in open_) {
        print "no label: " open_[name]
        missing = 1
    }
    # A dump that is read wrongly has nothing in it.
    for (call in kinds)
        if (!made[kinds[call]]) {
            print "none created: " kinds[call]
            missing = 1
        }
    exit missing
}
