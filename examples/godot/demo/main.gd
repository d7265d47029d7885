## Plays the opening shot of nine-ball picture by picture. The space bar plays another one.
extends Node3D

const GREEN := Color(0.05, 0.4, 0.25)

var trace: CaromTrace
var balls: Array[MeshInstance3D] = []
var events: Array[Dictionary] = []
var next_event := 0
var rack := 20
var time := 0.0


func _ready() -> void:
	var light := DirectionalLight3D.new()
	light.rotation_degrees = Vector3(-60, 30, 0)
	add_child(light)
	play()


func _unhandled_key_input(event: InputEvent) -> void:
	if event.is_action_pressed("ui_accept"):
		rack += 1
		play()


func play() -> void:
	trace = CaromTrace.break_shot("nine-ball", rack)
	if trace == null:
		push_error(CaromTrace.last_error())
		return
	events = trace.events()
	next_event = 0
	time = 0.0
	if balls.is_empty():
		build()


func build() -> void:
	var size := trace.table_size()
	var middle := Vector3(size.x / 2, 0, -size.y / 2)
	var cloth := MeshInstance3D.new()
	var plane := PlaneMesh.new()
	plane.size = size
	cloth.mesh = plane
	cloth.material_override = coloured(GREEN)
	cloth.position = middle
	add_child(cloth)
	var camera := Camera3D.new()
	add_child(camera)
	camera.look_at_from_position(Vector3(middle.x, 2.4, 0.9), middle)
	var ids := trace.ball_ids()
	var radii := trace.ball_radii()
	for i in ids.size():
		var ball := MeshInstance3D.new()
		var sphere := SphereMesh.new()
		sphere.radius = radii[i]
		sphere.height = 2 * radii[i]
		ball.mesh = sphere
		ball.material_override = coloured(
			Color.WHITE if ids[i] == "cue" else Color.from_hsv(float(i) / ids.size(), 0.8, 0.9)
		)
		add_child(ball)
		balls.append(ball)


func coloured(colour: Color) -> StandardMaterial3D:
	var material := StandardMaterial3D.new()
	material.albedo_color = colour
	return material


func _process(delta: float) -> void:
	if trace == null:
		return
	time += delta
	var transforms := trace.transforms(time)
	for i in balls.size():
		balls[i].transform = transforms[i]
	while next_event < events.size() and events[next_event]["time"] <= time:
		var event := events[next_event]
		# Here a game plays a sound as loud as the strength.
		if event["strength"] > 0.0:
			print("%.3f s: %s, %.3f N s" % [event["time"], event["kind"], event["strength"]])
		next_event += 1
