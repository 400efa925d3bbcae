-- Degree Constrained Triangulation in the drawing editor Ipe 7.2: triangulates the selected marks, or
-- the primary selection if it is a path of straight edges, and adds the edges to the page, each kind in
-- a layer of its own. Copy this file to ~/.ipe/ipelets and start Ipe anew.

label = "Degree Constrained Triangulation"
about = "Triangulates the selected marks, or the selected polygon, by the program dct."

-- The program: a name on the PATH, or where it is, as "/home/me/dct/bin/dct".
program = "dct"

local io, os = _G.io, _G.os -- Ipe hands them to no ipelet itself

local layer_of_kind = {
  boundary = "polygon",
  diagonal = "diagonals",
  partition = "partition",
  flipped = "flipped",
  fixed = "fixed",
}

-- The vertices of a path that is one straight ring or line; nil if it is another.
local function path_vertices(obj)
  local shape, matrix = obj:shape(), obj:matrix()
  if #shape ~= 1 or shape[1].type ~= "curve" then return nil end
  local vertices = {}
  for i, segment in ipairs(shape[1]) do
    if segment.type ~= "segment" then return nil end
    if i == 1 then vertices[1] = matrix * segment[1] end
    vertices[#vertices + 1] = matrix * segment[2]
  end
  return vertices
end

-- The positions of all selected marks.
local function marks(page)
  local vertices = {}
  for _, obj, selected in page:objects() do
    if selected and obj:type() == "reference" and obj:symbol():sub(1, 5) == "mark/" then
      vertices[#vertices + 1] = obj:matrix() * obj:position()
    end
  end
  return vertices
end

-- What is selected: its vertices and whether they are "polygon" or "points"; nil if it is neither.
local function selection(page)
  local primary = page:primarySelection()
  if primary and page[primary]:type() == "path" then
    return path_vertices(page[primary]), "polygon"
  end
  local vertices = marks(page)
  return #vertices > 0 and vertices or nil, "points"
end

local function write_vertices(name, vertices)
  local file = assert(io.open(name, "w"))
  for _, v in ipairs(vertices) do
    file:write((string.format("%.17g %.17g\n", v.x, v.y):gsub(",", ".")))
  end
  file:close()
end

local function contents(name)
  local file = io.open(name, "r")
  if not file then return "" end
  local text = file:read("a")
  file:close()
  return text
end

local function quoted(word)
  return config.platform == "win" and '"' .. word .. '"' or "'" .. word:gsub("'", "'\\''") .. "'"
end

-- Runs the program; gives its result as JSON, or nil and what it says.
local function run_program(vertices, kind, options)
  local name = os.tmpname()
  local input, output, said = name .. ".txt", name .. ".json", name .. ".err"
  write_vertices(input, vertices)
  local done = os.execute(quoted(program) .. " triangulate " .. quoted(input) .. " --as " .. kind
    .. " --quiet " .. options .. " -o " .. quoted(output) .. " 2> " .. quoted(said))
  local result, message = contents(output), contents(said)
  for _, file in ipairs({ name, input, output, said }) do os.remove(file) end
  if done and result ~= "" then return result end
  return nil, (message:gsub(input, "selection", 1))
end

-- The edges of a result, {from, to, kind} each, with vertices numbered from 0 on.
local function edges(result)
  local list = {}
  local text = result:match('"edgeList"%s*:%s*(%[.*)') or ""
  for from, to, kind in text:gmatch('%[%s*(%d+)%s*,%s*(%d+)%s*,%s*"(%a+)"%s*%]') do
    list[#list + 1] = { tonumber(from), tonumber(to), kind }
  end
  return list
end

local function has_layer(page, name)
  for _, layer in ipairs(page:layers()) do
    if layer == name then return true end
  end
  return false
end

local function add_edges(page, view, attributes, vertices, list, domain)
  for _, edge in ipairs(list) do
    local from, to, kind = vertices[edge[1] + 1], vertices[edge[2] + 1], edge[3]
    local layer = layer_of_kind[kind]
    if layer and not (domain == "polygon" and kind == "boundary") then -- the path is there already
      if not has_layer(page, layer) then page:addLayer(layer) end
      page:setVisible(view, layer, true)
      local segment = { type = "curve", closed = false, { type = "segment", from, to } }
      page:insert(nil, ipe.Path(attributes, { segment }), nil, layer)
    end
  end
end

local function triangulate(model, options, only, name)
  local vertices, domain = selection(model:page())
  if not vertices then
    model:warning("Select marks, or one path of straight edges.")
    return
  end
  if only and only ~= domain then
    model:warning(only == "points" and "Select marks, not a path." or "Select a path, not marks.")
    return
  end
  local result, message = run_program(vertices, domain, options)
  if not result then
    model:warning("The program " .. program .. " made no triangulation.", message)
    return
  end
  local list = edges(result)
  local attributes = model.attributes
  local t = {
    label = name,
    pno = model.pno,
    vno = model.vno,
    original = model:page():clone(),
    undo = _G.revertOriginal,
    redo = function(t, doc) add_edges(doc[t.pno], t.vno, attributes, vertices, list, domain) end,
  }
  model:register(t)
end

local function method(name, options, only)
  return { label = name, run = function(model) triangulate(model, options, only, name) end }
end

methods = {
  method("Delaunay", "--algorithm delaunay", "points"),
  method("Monotone", "--algorithm monotone", "polygon"),
  method("Convex, Even (Hertel-Mehlhorn)", "--algorithm convex-even", "polygon"),
  method("Scan-Flip", "--flip"),
  method("Most Even", "--optimize even --time-limit 10"),
}
