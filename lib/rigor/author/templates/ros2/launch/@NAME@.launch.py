"""Starts the robot @NAME@ on mock hardware: its description, ros2_control and the controllers."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import UnlessCondition
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    share = FindPackageShare('@NAME@_description')
    use_sim = LaunchConfiguration('use_sim')
    controllers = PathJoinSubstitution([share, 'config', 'controllers.yaml'])
    xacro_file = PathJoinSubstitution([share, 'urdf', '@NAME@.urdf.xacro'])
    expanded = Command([FindExecutable(name='xacro'), ' ', xacro_file, ' use_sim:=', use_sim])

    return LaunchDescription([
        DeclareLaunchArgument(
            'use_sim', default_value='false', choices=['true', 'false'],
            description='Whether Gazebo runs the controllers; it brings its own controller manager.'),
        Node(
            package='robot_state_publisher',
            executable='robot_state_publisher',
            parameters=[{
                'robot_description': ParameterValue(expanded, value_type=str),
                'use_sim_time': ParameterValue(use_sim, value_type=bool),
            }],
        ),
        Node(
            package='controller_manager',
            executable='ros2_control_node',
            parameters=[controllers],
            remappings=[('~/robot_description', '/robot_description')],
            condition=UnlessCondition(use_sim),
        ),
        Node(
            package='controller_manager',
            executable='spawner',
            arguments=['joint_state_broadcaster', 'diff_drive_controller'],
        ),
    ])
